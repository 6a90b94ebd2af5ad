// The frame's numbers, as every pixel reads them.
#include "shared/frame_block.glsl"

#ifdef __cplusplus
thread_local FrameData frame;
#else
layout(std140) uniform FrameBlock { FrameData frame; };
#endif
