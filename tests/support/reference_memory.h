// What the reference said of the same rays or stars in an earlier run: it changes only when its code does. Kept in the
// folder NULLSCOPE_REFERENCE_MEMORY, under the text of the file NULLSCOPE_REFERENCE_MARK, which stands for that code.
// Without either, and at any other depth than quick, everything is computed.
#pragma once
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace nullscope::test {

class ReferenceMemory {
public:
    // folder: of one code; made if it is not there, and others beside it go. Empty: nothing is kept.
    explicit ReferenceMemory(std::filesystem::path folder);
    static const ReferenceMemory& of_this_run();

    // What is kept under the question, word for word, else what compute gives; that is kept where it took long enough
    // to be worth reading. A file that was cut off or changed counts as none.
    template <class T>
    std::vector<T> answer(const std::string& question, const std::function<std::vector<T>()>& compute) const {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::string bytes = bytes_of(question, sizeof(T), [&] {
            const std::vector<T> all = compute();
            return std::string(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(T));
        });
        std::vector<T> all(bytes.size() / sizeof(T));
        if (!all.empty()) std::memcpy(static_cast<void*>(all.data()), bytes.data(), bytes.size());
        return all;
    }

private:
    std::string bytes_of(const std::string& question, std::size_t size,
                         const std::function<std::string()>& compute) const;

    std::filesystem::path folder_;
};

}  // namespace nullscope::test
