// Polarisation of thermal synchrotron light, and Faraday's rotation and conversion by these electrons. Of Q, U, V only ratios to I are taken
// from fits: light in I is that of medium/synchrotron.glsl.
// Emission: Dexter 2016 (MNRAS 462, 115), equations A12 to A20; absorption by Kirchhoff's law; rotation and conversion: Shcherbakov 2008
// (ApJ 688, 695) with the corrections of Dexter, equations B4 to B15. Signs: conversion from the dispersion of a cold plasma, where light
// across the field runs ahead; rotation towards growing angles where the field points to the camera; V as core/stokes_transfer.glsl.
#include "generated/medium_matter"
#include "medium/electrons.glsl"
#include "medium/light.glsl"
#include "medium/matter.glsl"
#include "medium/motion.glsl"
#include "medium/place.glsl"
#include "medium/screen.glsl"

#define FARADAY_LOG2 -0.945904533   // log2 of 2 e^2/(m c) 1e-9, in units of LAW_UNIT and of its frequency squared
#define FARADAY_COLD 1.0            // temperature in m c^2/k below which rotation is corrected as there

// K_1(x)/K_2(x), x >= 1 with t = 1/x: to 1e-6.
float bessel_12(float t) { return (1.0 + t * (2.03264625 + t * 0.8150025)) / (1.0 + t * (3.53264625 + t * (4.23857116 + t * 1.61544117))); }

// K_0(x), x <= 1: to 4e-5.
float bessel_0(float x) {
    float square = 0.25 * x * x;
    float growing = 1.0 + square * (1.0 + square * 0.25 * (1.0 + square / 9.0));
    float rest = square * (1.0 + square * 0.375 * (1.0 + square * (11.0 / 81.0)));
    return (-log(0.5 * x) - 0.5772156649) * growing + rest;
}

// K_0/K_2 and K_1/K_2 at 1/theta.
vec2 bessel_ratios(float theta) {
    float x = min(1.0 / theta, 1.0);
    float hot = bessel_0(x) * x * x * exp(x) / (2.0 * bessel_part(x));
    float cold = bessel_12(min(theta, 1.0));
    return theta > 1.0 ? vec2(hot, 0.5 * (1.0 - hot) * x) : vec2(1.0 - 2.0 * theta * cold, cold);
}

// Of X = theta sqrt(sqrt(2) 1000 nu_B sin/nu): what remains of the conversion, and what the rotation lacks, over K_2.
float faraday_conversion(float x) {
    float log_x = log2(x);
    float far = exp(-x / 47.2);
    float beyond = 0.5 + 0.5 * tanh(clamp(10.0 * (log_x - 6.906890596) * 0.69314718, -9.0, 9.0));
    return 2.011 * exp(-exp2(1.035 * log_x) / 4.7) - cos(0.5 * x) * exp(-exp2(1.2 * log_x) / 2.73) - 0.011 * far +
           beyond * (0.011 * far - 369.693429 * exp2(-2.666666667 * log_x));
}
float faraday_lack(float x) { return 0.43793091 * log(1.0 + 0.00185777 * exp2(1.50316886 * log2(x))); }

MediumStokes medium_stokes(MediumPlace place, MediumMatter matter, vec2 phase) {
    vec3 seen = medium_seen(place, matter);
    float log_g = log2(matter.g);
    float frequency = LAW_FREQUENCY * exp2(-LAW_SHIFT * log_g);
    float cosine = clamp(dot(seen, matter.field_way), -1.0, 1.0);
    float sine = clamp(length(cross(seen, matter.field_way)), 1.0e-3, 1.0);
    float theta = clamp(matter.temperature, 1.0, 1.0e14) / ELECTRON_K;
    float gyro = GYRO_GHZ * clamp(matter.field, 1.0e-6, 1.0e9);
    float y = exp2((log2(1.5 * gyro * sine) + 2.0 * log2(theta) - log2(frequency)) * (1.0 / 3.0));   // (nu/nu_c)^(-1/3)
    float linear = (1.0 + y * (0.93193 + y * 0.499873)) / (1.0 + y * (1.92 + y * 0.9977));
    float circular = y * (2.03773 + y * (3.42319 + y * 1.81348) + 0.0292545 * sqrt(y)) / (2.5651 * (1.0 + y * (1.92 + y * 0.9977)));
    circular *= 4.0 * cosine / (3.0 * theta * sine);
    float most = sqrt(max(1.0 - linear * linear, 0.0));
    vec2 way = screen_direction(place, matter, seen, phase);
    MediumStokes stokes;
    stokes.emitted = vec3(linear * way, clamp(circular, -most, most));
    stokes.absorbed = stokes.emitted;
    stokes.turned = vec3(0.0);
#ifdef MEDIUM_FARADAY
    float log_turn = medium_log_density(matter) + LAW_UNIT + FARADAY_LOG2 + log2(gyro) + (2.0 * LAW_SHIFT - 1.0) * log_g;
    float turn = matter.density > 0.0 ? matter.inside * emission_number(log_turn) : 0.0;
    float x = clamp(theta * sqrt(1414.21356 * gyro * sine / frequency), 1.0e-3, 1.0e6);
    vec2 ratios = bessel_ratios(theta);
    float rest = max(1.0 - faraday_lack(x) / bessel_0(1.0 / max(theta, FARADAY_COLD)), 0.0);
    float converted = 0.5 * turn * sine * sine * (gyro / frequency) * faraday_conversion(x) * (ratios.y + 6.0 * theta);
    stokes.turned = vec3(converted * way, turn * cosine * ratios.x * rest);
#endif
    return stokes;
}
