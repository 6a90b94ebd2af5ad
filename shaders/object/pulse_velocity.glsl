// dx/dt of a pulsating sphere's surface, when the light left.
#include "object/pulse.glsl"

vec3 pulse_velocity(int i, RayPlace place) {
    vec4 form = body_form(i);
    return (form.x * form.y * form.w * cos(form.z - form.w * place.delay)) * place.outward;
}
