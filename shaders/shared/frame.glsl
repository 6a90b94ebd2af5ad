// The frame's numbers, as every pixel reads them.
#include "shared/frame_block.glsl"

#ifdef __cplusplus
thread_local FrameData frame;
#else
#ifdef RAYS_OF_A_LIST
layout(std140) uniform FrameBlock { FrameData every_ray; };
FrameData frame;   // a ray's own (stage/ray_list.frag)
#else
layout(std140) uniform FrameBlock { FrameData frame; };
#endif
#endif
