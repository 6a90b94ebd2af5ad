// Of a picture in layers (render/picture_layers.h): the part of what a ray meets that the layer shows.
#define LAYER_DISC 1      // first image order, the third has all higher ones
#define LAYER_BODIES 4
#define LAYER_SKY 5
#define LAYER_MEDIUM 6
#define LAYER_STOKES 7    // Q and U of all light
#ifdef LAYERS
#define LAYER_ALL 0
#define LAYER_DISC_SHARES 8    // of each order of the disc: how much of the pixel's light it hides
#define LAYER_OTHER_SHARES 9   // of bodies, sky and matter along the ray

uniform int layer_shown;

// light: of something that covers `share` of what is behind it.
vec3 layer_light(vec3 light, float share, int layer) {
    if (layer_shown == LAYER_ALL || layer_shown == layer) return light;
    int place = layer_shown == LAYER_DISC_SHARES ? layer - LAYER_DISC : layer_shown == LAYER_OTHER_SHARES ? layer - LAYER_BODIES : -1;
    return share * vec3(place == 0, place == 1, place == 2);
}
#else
#define layer_light(light, share, layer) (light)
#endif
