#include "render/compute_picture.h"

#include <utility>

namespace nullscope {

gl::Program ComputePicture::made(const std::string& text, gl::Stored stored,
                                 const std::function<void(const gl::Program&)>& name_inputs) {
    gl::ComputeProgram made = gl::make_compute_program(text, stored);
    if (made.program)
        name_inputs(made.program);
    else
        refused_ = made.refusal;
    return std::move(made.program);
}

const gl::Program* ComputePicture::program(const Key& key, gl::Stored stored, const std::function<std::string()>& text,
                                           const std::function<void(const gl::Program&)>& name_inputs) {
    const auto [found, is_new] = programs_.try_emplace({key, stored});
    if (is_new) found->second = made(text(), stored, name_inputs);
    if (!found->second) return nullptr;
    ++drawn_;
    return &found->second;
}

const gl::TileList* ComputePicture::tiles(Stage stage, int across, int first, int last, const Inputs& name_inputs,
                                          const Inputs& tell) {
    const auto [found, is_new] = lists_.try_emplace(stage);
    if (is_new) found->second = made(tile_list_source(stage), {}, name_inputs);
    if (!found->second) return nullptr;
    tell(found->second);
    list_.find(found->second, across, first, last);
    return &list_;
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
