// One level of the halo and half as much light as it of all coarser ones: light outside of a radius falls as one over it, as
// behind an aperture (a point spread of r^-3).
uniform highp sampler2D source_texture;
uniform highp sampler2D bloom_texture;
out vec4 colour;

void main() {
    vec2 at = gl_FragCoord.xy / vec2(textureSize(source_texture, 0));
    vec2 coarse = 0.5 / vec2(textureSize(bloom_texture, 0));
    vec3 wide = 0.25 * (textureLod(bloom_texture, at - coarse, 0.0).rgb + textureLod(bloom_texture, at + coarse, 0.0).rgb +
                        textureLod(bloom_texture, at + vec2(coarse.x, -coarse.y), 0.0).rgb +
                        textureLod(bloom_texture, at + vec2(-coarse.x, coarse.y), 0.0).rgb);
    colour = vec4(0.5 * (textureLod(source_texture, at, 0.0).rgb + wide), 1.0);
}
