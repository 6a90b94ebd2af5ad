#include "shaderlib/flat_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <string_view>
#include <utility>

namespace nullscope {
namespace {

constexpr std::string_view kRead = "frame.", kBlock = "struct FrameData {",
                           kBlockEnd = "uniform FrameBlock { FrameData frame; };", kMain = "void main() {";

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Calls found(where, name) for each frame.NAME of the text; a comment may name the file.
template <class Found>
void each_read(const std::string& text, Found found) {
    for (std::size_t at = text.find(kRead); at != std::string::npos; at = text.find(kRead, at + 1)) {
        if (at > 0 && (is_of_name(text[at - 1]) || text[at - 1] == '.' || text[at - 1] == '/')) continue;
        const std::size_t name = at + kRead.size();
        std::size_t end = name;
        while (end < text.size() && is_of_name(text[end])) ++end;
        found(at, text.substr(name, end - name));
    }
}

// After the lines that every text begins with: what follows has its own numbers of lines.
std::size_t after_head(const std::string& text) {
    const std::string_view head = shader_head(text.starts_with("#version 300") ? Glsl::kEs300 : Glsl::k330);
    return text.starts_with(head) ? head.size() : 0;
}

}  // namespace

std::vector<std::string> frame_members_read(const std::string& text) {
    std::vector<std::pair<std::string, int>> counts;
    each_read(text, [&](std::size_t, const std::string& name) {
        const auto known = std::ranges::find(counts, name, &std::pair<std::string, int>::first);
        if (known == counts.end())
            counts.emplace_back(name, 1);
        else
            ++known->second;
    });
    std::ranges::stable_sort(counts, std::greater{}, &std::pair<std::string, int>::second);
    std::vector<std::string> names;
    names.reserve(counts.size());
    for (const auto& [name, count] : counts) names.push_back(name);
    return names;
}

namespace {

std::vector<std::string> most_read(const std::string& text, int most) {
    std::vector<std::string> names = frame_members_read(text);
    names.resize(std::min(names.size(), static_cast<std::size_t>(std::max(most, 0))));
    return names;
}

std::string reads_of(const std::vector<std::string>& names) {
    std::string reads;
    for (const std::string& name : names) reads += fmt::format(" flat_{0} = frame.{0};", name);
    return reads;
}

// The text that reads flat_NAME in the place of these members.
std::string renamed(std::string text, const std::vector<std::string>& names) {
    std::vector<std::size_t> reads;
    each_read(text, [&](std::size_t at, const std::string& name) {
        if (std::ranges::find(names, name) != names.end()) reads.push_back(at);
    });
    for (auto at = reads.rbegin(); at != reads.rend(); ++at) text.replace(*at, kRead.size(), "flat_");
    return text;
}

}  // namespace

ShaderSource with_flat_frame(const ShaderSource& source, int most) {
    const std::size_t block = source.fragment.find(kBlock), main = source.vertex.find(kMain);
    if (block == std::string::npos || source.fragment.find(kBlockEnd) == std::string::npos || main == std::string::npos)
        return source;
    const std::vector<std::string> names = most_read(source.fragment, most);
    ShaderSource flat = source;
    std::string inputs, outputs;
    for (const std::string& name : names) {
        inputs += fmt::format("flat in highp vec4 flat_{};\n", name);
        outputs += fmt::format("flat out highp vec4 flat_{};\n", name);
    }
    flat.vertex.insert(main + kMain.size(), reads_of(names));
    if (source.vertex.find(kBlockEnd) == std::string::npos)
        outputs = "layout(std140) " + std::string(kBlockEnd) + "\n" + outputs;
    if (source.vertex.find(kBlock) == std::string::npos) {
        const std::size_t closed = source.fragment.find("};", block) + 2;
        outputs = source.fragment.substr(block, closed - block) + "\n" + outputs;
    }
    flat.vertex.insert(after_head(source.vertex), outputs);

    flat.fragment = renamed(source.fragment, names);
    flat.fragment.insert(after_head(source.fragment), inputs);
    return flat;
}

std::string with_frame_read_once(const std::string& text, int most) {
    const std::size_t block = text.find(kBlockEnd);
    if (block == std::string::npos || text.find(kMain) == std::string::npos) return text;
    const std::vector<std::string> names = most_read(text, most);
    std::string numbers;
    for (const std::string& name : names) numbers += fmt::format(" vec4 flat_{};", name);
    std::string once = renamed(text, names);
    once.insert(once.find(kMain) + kMain.size(), reads_of(names));
    once.insert(once.find(kBlockEnd) + kBlockEnd.size(), numbers);
    return once;
}

}  // namespace nullscope
