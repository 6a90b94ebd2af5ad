// What the reference said of the same rays in an earlier run: its frames change only when its code does. Kept in the
// folder NULLSCOPE_REFERENCE_MEMORY, under the text of the file NULLSCOPE_REFERENCE_MARK, which stands for that code.
// Without either, and at any other depth than quick, everything is computed.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/ray.h"

namespace nullscope::test {

class ReferenceMemory {
public:
    // folder: of one code; made if it is not there, and others beside it go. Empty: nothing is kept.
    explicit ReferenceMemory(std::filesystem::path folder);
    static const ReferenceMemory& of_this_run();

    // What is kept under the question, word for word, else what compute gives; that is kept where it took long enough
    // to be worth reading. A file that was cut off or changed counts as none.
    std::vector<RayPixel> answer(const std::string& question,
                                 const std::function<std::vector<RayPixel>()>& compute) const;

private:
    std::filesystem::path folder_;
};

}  // namespace nullscope::test
