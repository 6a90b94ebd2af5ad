// Bodies of which a scene has several of one kind: which of them are asked.
#define MARCH_LISTS
uvec2 bodies_shown = uvec2(0xffffffffu, 0xffffffffu);   // by this tile
uvec2 bodies_near = uvec2(0xffffffffu, 0xffffffffu);    // to the next part of the way
float march_first = 0.0;     // none of them is met at a smaller swept angle
float march_last = 1.0e30;   // or at a larger one
