#include "render/compute_picture.h"

#include <utility>

namespace nullscope {

const gl::Program* ComputePicture::program(const Key& key, gl::Format stored, const std::function<std::string()>& text,
                                           const std::function<void(const gl::Program&)>& name_inputs) {
    const auto [found, is_new] = programs_.try_emplace({key, stored});
    if (is_new) {
        gl::ComputeProgram made = gl::make_compute_program(text(), stored);
        if (made.program)
            name_inputs(made.program);
        else
            refused_ = made.refusal.substr(0, made.refusal.find('\n'));
        found->second = std::move(made.program);
    }
    if (!found->second) return nullptr;
    ++drawn_;
    return &found->second;
}

std::string ComputePicture::refusal() const {
    if (!wanted_) return "";
    return gl::computes() ? refused_ : "this OpenGL is older than 4.3";
}

std::string ComputePicture::take_refusal() {
    std::string why = told_ ? std::string() : refusal();
    told_ = told_ || !why.empty();
    return why;
}

}  // namespace nullscope
