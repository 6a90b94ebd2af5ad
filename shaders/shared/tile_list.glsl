// Tiles of the picture by compute, listed by one shader (stage/tile_list.comp) and drawn by the next, a group each (gl/compute.h). Groups lie in
// rows: drivers grant 65535 of them along each axis. What is listed is what a group draws (GROUP_SIDE), of which a tile may have several.
#define LIST_ACROSS 256u

layout(std430, binding = 0) buffer TileList {
    uint tiles;
    uint groups_across;
    uint groups_up;
    uint groups_deep;   // 1
    uint listed[];      // column and, 65536 times, row of each
} tile_list;
