// What pictures say of themselves, and the scenes in it.
#include <sstream>

#include "fuzz.h"
#include "image/picture_texts.h"
#include "scenefile/picture_scene.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    std::istringstream file{std::string(fuzz::text_of(data, size))};
    const auto texts = read_texts(file, "picture");
    if (!texts) {
        fuzz::must_be_a_good_error(texts.error());
        return 0;
    }
    std::size_t bytes = 0;
    for (const auto& [keyword, text] : *texts) bytes += text.size();
    fuzz::must(bytes <= 1100 * size + kMostTextBytes, "texts are not much longer than the file");
    fuzz::must(put_together(in_pieces(*texts, 240)).size() <= texts->size(), "pieces are put together");
    const auto scene = scene_of_words(*texts, kSceneWord, "picture", [](const std::string&) {});
    if (!scene) fuzz::must_be_a_good_error(scene.error());
    return 0;
}
