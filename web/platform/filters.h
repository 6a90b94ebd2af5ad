// What a browser's context can do, which only the page can ask it.
#pragma once

namespace nullscope::gl {

// Floats as targets that are blended and filtered (EXT_color_buffer_float, EXT_float_blend, OES_texture_float_linear): else light that is
// filtered is in halves (gl::filtered_light()).
extern bool filters_floats;

}  // namespace nullscope::gl
