// Undo and redo: the scenes that the viewer has come to rest on, one after another.
#pragma once
#include <string>
#include <vector>

#include "studio/view_state.h"

namespace nullscope::viewer {

class History {
public:
    // The view has come to rest: a step, if its scene, its method or what is switched off differs from the step before. Moves of the camera that follow
    // each other are one step, unless view.jumps says that a command put it elsewhere between them. Another size of the window and other
    // hidden bodies are no step. Steps that were undone are forgotten then. Cost: 0.1 ms where nothing has changed, and a scene is kept for
    // each of the last kMostSteps.
    void rest(const ViewState& view);

    // The scene was saved to a file, whose name is then that of all steps since it was opened as `from`: a save is no step.
    void saved(const std::string& from, const std::string& file);

    // Goes a step back, or forward again; false: there is none. `what`: the keys that change, the effects that are switched
    // and whether sides are swapped, for a message.
    bool undo(ViewState& view, std::string& what);
    bool redo(ViewState& view, std::string& what);

private:
    static constexpr std::size_t kMostSteps = 500;
    struct Words {          // the scene as text, without the picture's size
        std::string place;  // of the camera and the clock: what a move changes
        std::string rest;
    };
    struct Step {
        std::string source;
        Scene loaded, scene;
        EffectSet off;
        MethodWish method;
        HiddenBodies hidden;  // when it was last at rest
        int sides;            // ViewState::sides, likewise
        Words words;
        int jumps;   // ViewState::jumps
        bool moved;  // the camera alone: a further move is the same step
    };
    static Words words_of(const Scene& scene);
    static bool moved_since(const Step& step, const ViewState& view, const Words& words);
    bool go_to(std::size_t step, ViewState& view, std::string& what);
    std::vector<Step> steps_;
    std::size_t at_ = 0;
};

}  // namespace nullscope::viewer
