// The picture's passes by compute shaders (gl/compute.h), where they are wanted and the driver has them.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "gl/compute.h"
#include "plan/effects.h"
#include "shaderlib/shader_source.h"

namespace nullscope {

class ComputePicture {
public:
    using Key = std::tuple<Stage, Output, EffectSet, Method, std::string, BodyText>;

    void want(bool wanted, bool patches) {
        if (patches != patches_) programs_.clear();  // others have no patches, or have them in vain
        wanted_ = wanted, patches_ = patches;
    }
    bool patches() const { return patches_; }
    // Is what this stage draws to be computed, as far as is known before its program is there?
    bool wants(Stage stage) const { return wanted_ && computes(stage) && gl::computes(); }

    // The same of pixels that are drawn again with more rays.
    bool wants_patches(Stage stage) const { return patches_ && wants(stage); }

    // Of a stage that it wants, to store like this; made by the first call. nullptr: the driver refuses it, fragments draw it.
    const gl::Program* program(const Key& key, gl::Stored stored, const std::function<std::string()>& text,
                               const std::function<void(const gl::Program&)>& name_inputs);

    // The tiles that this stage draws, of a picture, or lattice, of `across` tiles a row, in the rows from `first` up to but not including `last`. What
    // tells them must be bound, and set by `tell`. nullptr: the driver refuses to list them.
    using Inputs = std::function<void(const gl::Program&)>;
    const gl::TileList* tiles(Stage stage, int across, int first, int last, const Inputs& name_inputs,
                              const Inputs& tell);

    // Do compute shaders draw, as far as is known?
    bool draws() const { return wanted_ && refusal().empty(); }
    int drawn() const { return drawn_; }  // times that a program was found
    // Why fragments draw what compute was wanted for, a line; empty where compute does, or is not wanted. told: once.
    std::string refusal() const;
    std::string take_refusal();

private:
    gl::Program made(const std::string& text, gl::Stored stored,
                     const std::function<void(const gl::Program&)>& name_inputs);

    bool wanted_ = false, patches_ = false, told_ = false;
    int drawn_ = 0;
    std::map<Stage, gl::Program> lists_;
    gl::TileList list_;
    std::map<std::pair<Key, gl::Stored>, gl::Program> programs_;  // one without a name: refused
    std::string refused_;
};

}  // namespace nullscope
