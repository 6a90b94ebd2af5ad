// How what the picture in the window shows moves with a key of its scene (gradient/picture_motion.h): a grid of arrows, found on a thread of its own while
// the picture rests.
#pragma once
#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "scene/scene.h"

namespace nullscope::viewer {

// A key that can be chosen, and the step that is asked about: "spin" and 0.01, "camera.theta" and 1 degree.
struct ChangeKey {
    std::string name;
    double step;        // in the unit of gradient/parameter.h
    std::string words;  // of the step: "+ 0.01", "+ 1°"
};
std::vector<ChangeKey> change_keys(const Scene& scene);

// In px of the scene's picture: from where, and how far by one step.
struct ChangeArrow {
    double x, y, right, down;
};

class ChangeWatch {
public:
    ~ChangeWatch() { stop(); }
    // The picture of this number shows this scene, and rests or does not. Of another number or key, arrows are forgotten, and at rest found anew: some
    // 0.5 ms each, of which there are as many as ticks (annotate/ticks.h). news: from the thread, once they are there. Returns within a millisecond.
    void look(int number, const Scene& scene, const ChangeKey& key, bool rests, std::function<void()> news);
    void forget();
    bool at_work() const { return waits_; }  // until take_news() was true
    bool take_news() {                       // once, when they are there
        const bool news = news_.exchange(false);
        waits_ = waits_ && !news;
        return news;
    }
    const std::vector<ChangeArrow>& arrows() const;                        // none until all are there
    std::string error() const { return works_ ? std::string() : error_; }  // why there are none, or nothing

private:
    void stop();
    void find(const std::stop_token& stop, const Scene& scene, const ChangeKey& key);
    bool waits_ = false;
    int number_ = -1;
    std::string key_;
    std::vector<ChangeArrow> arrows_;  // these two are the thread's while it works
    std::string error_;
    std::atomic<bool> works_ = false, news_ = false;
    std::jthread worker_;  // last: ends before what it uses
};

}  // namespace nullscope::viewer
