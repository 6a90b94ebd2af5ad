// Luminance of linear Rec. 709 light (Recommendation ITU-R BT.709).
float luminance_of(vec3 light) { return dot(light, vec3(0.2126, 0.7152, 0.0722)); }
