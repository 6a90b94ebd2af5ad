// The pictures of a film or a sequence on disk, and the stamp file with them: the text that frame_stamp.h makes. Pictures
// are kept from one run to the next only under an equal stamp. The stamp file is locked while a run draws; the kernel frees
// it when the process ends, however it ends.
#pragma once
#include <string>

#include "base/result.h"
#include "cli/arguments.h"
#include "cli/frame_names.h"

namespace nullscope::cli {

class FrameStore {
public:
    // A folder of the film's own, made if it is missing. Under another stamp its pictures are removed, and one line on
    // standard error says so. Errors: another run draws there (1), what the system says.
    static Result<FrameStore> open_film(const std::string& folder, const std::string& stamp);
    // The stamp file is NAME.png.stamp for NAME%05d.png. resume: pictures that are there stay. Errors: as above; pictures
    // of another stamp, or of none (bad input).
    static Result<FrameStore> open_sequence(const FrameNames& names, Frames frames, const std::string& stamp,
                                            bool resume);

    FrameStore(FrameStore&& other) noexcept;
    FrameStore(const FrameStore&) = delete;
    FrameStore& operator=(const FrameStore&) = delete;
    FrameStore& operator=(FrameStore&&) = delete;
    ~FrameStore();  // a stamp without pictures goes with it

    std::string file(int frame) const { return names_.of(frame); }
    // Whether that picture is there and was drawn under this stamp: it is not older than the stamp file.
    bool has(int frame) const;
    void drew_one() { new_ = false; }

private:
    FrameStore(FrameNames names, std::string stamp_file, int descriptor);
    static Result<FrameStore> lock(const FrameNames& names, const std::string& stamp_file, const std::string& what);
    Result<std::string> read() const;
    Status write(const std::string& stamp) const;

    FrameNames names_;
    std::string stamp_file_;
    int descriptor_;
    bool new_ = false;  // the stamp is this run's, and there is no picture yet
};

}  // namespace nullscope::cli
