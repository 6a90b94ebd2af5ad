// From the picture in linear light to the display.
out vec4 colour;

void main() {
    vec3 light = texelFetch(picture_texture, ivec2(gl_FragCoord.xy), 0).rgb;
    colour = vec4(display_encode(light, frame.image.w), 1.0);
}
