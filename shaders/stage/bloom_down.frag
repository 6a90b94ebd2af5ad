// Half the size, rounded up: each texel the mean of the 4x4 around it, so that every texel of an even source counts the same.
uniform highp sampler2D source_texture;
out vec4 colour;

void main() {
    ivec2 size = textureSize(source_texture, 0);
    vec2 texel = 1.0 / vec2(size);
    vec2 at = gl_FragCoord.xy / vec2((size + 1) / 2);
    colour = 0.25 * (textureLod(source_texture, at - texel, 0.0) + textureLod(source_texture, at + texel, 0.0) +
                     textureLod(source_texture, at + vec2(texel.x, -texel.y), 0.0) + textureLod(source_texture, at + vec2(-texel.x, texel.y), 0.0));
}
