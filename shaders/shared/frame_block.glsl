// What one frame tells every pixel: the uniform block (bodies and hot spots: shared/objects.glsl). vec4 members only, so that std140 and C++ agree without padding;
// a test compares the driver's offsets with offsetof. Everything that would cancel in float is formed in double on the host.
// Members of an effect that is off are not in the block; C++ has them all.
struct FrameData {
    vec4 image;        // width, height in px, angle of a pixel's height in the line of sight (rad, of a pinhole its tangent), exposure factor
    vec4 sight;        // the line of sight, px from the lower left corner; a pixel's width over its height; the root of its solid angle there, rad
    vec4 ray_0;        // view direction of pixel (x, y) of a pinhole, not normalised: ray_0 + x ray_x + y ray_y, world axes, .w = 0;
    vec4 ray_x;        //   x, y: picture_place(), core/view.glsl
    vec4 ray_y;
    vec4 polar_0;      // the same direction along `meridian`, `transverse`, `radial` and (.w) along the critical direction's
    vec4 polar_x;      //   tangent in the meridian's plane, towards the sky: each keeps its digits where it is small, at a hole of
    vec4 polar_y;      //   a few microradians and at a photon ring that fills the screen
    vec4 radial;       // outward radial unit vector e at the camera, .w = factor on g by what light.* switches off, else 1; the other two make a right-handed frame with it:
    vec4 meridian;     //   in the plane of e and the image's centre, .w = 0
    vec4 transverse;   //   e x meridian, .w = 0
    vec4 shift;        // energy and (.z) infall of the radial frame (spacetime/radial_frame.h), .y zeta0, .w fate of rays that do not escape
#ifdef BLOCK_PROJECTION
    vec4 projection;   // its number (scene/scene.h); how far from the line of sight it shows anything, px of a pixel's height: a fisheye's
                       //   radius, else the height; px between places that see the same, 0 if there are none; 0
#endif
#ifdef BLOCK_WARP
    vec4 warp;         // half the picture's height, px; its middle from the line of sight, to the right and upward, px of a pixel's height; power of its intensities, 0: none
#endif
#ifdef BLOCK_LENSING
    vec4 strip;        // cosine and sine of the critical direction's angle from e (a ray nearer to e escapes), 1/w0, first row of the inner rays in the strip
    vec4 orbit;        // sin(theta_c) = k sin(alpha), cos(chi0), a0, a1 of the deflection table
    vec4 series;       // a2 of the deflection table, chi0; rays that come back: their first row by the centre, tan(theta_c/4)
#endif
#ifdef BLOCK_ZOOM
    vec4 polar_length; // of a zoom the polar forms are those of the direction before aberration, v = ray_0 + x ray_x + y ray_y, seen by an
                       //   observer at rest: this times (|v| - 1) is to be added,
    vec4 polar_weight; //   and the sum to be divided by x + px y + py z + (|v| - 1) w
    vec4 ring;         // observer/ring_view.h: swept angle and light time that the picture leaves out, rays that have swept .z before half of it;
                       //   how much a ray that winds sweeps at most between the disc and either of its ends. About a rotating hole: azimuth, light
                       //   time and crossings of the equatorial plane that the picture leaves out, 0
#endif
#ifdef BLOCK_ABERRATION
    vec4 boost;        // direction of motion in world axes, .w = stretch sqrt((1+v)/(1-v)) of directions, 1 without aberration
    vec4 boost_colour; // the stretch of frequencies, 1 without Doppler shift; log2 of the brightness of the sky's temperature, 0, 0
#endif
#ifdef BLOCK_SKY
    vec4 sky;          // texels per radian of the sky's finest level, highest level, brightness
#endif
#ifdef BLOCK_SKY_SHIFT
    vec4 sky_light;    // factor on the sky's light; for a moving camera on that and a black body's, .w = log2 of the sky's temperature (K)
#endif
#ifdef BLOCK_DISC
    vec4 disc_normal;  // unit normal of the disc, .w = normal . radial (0 exactly for a camera in the plane)
    vec4 disc_x;       // disc's x axis, .w = inner radius (r_s)
    vec4 disc_y;       // disc's y axis, .w = outer radius (r_s)
    vec4 disc_map;     // cos and sin of the image's rotation, each over 2 outer; texels per r_s; highest level
    vec4 disc_surface;    // opacity, rim fade (fraction of the width, 0 = none), brightness; how many of a ray's crossings it is not met by
    vec4 critical;     // images of the disc next to the critical direction: C of its rims, log2(e)/a, first angle
    vec4 critical_bend;   // the next term, table/critical_images.h: of the inner rim, and of the outer one
#endif
#ifdef BLOCK_THERMAL_DISC
    vec4 disc_heat;    // 1/inner, flow cells per unit of ln r, log2 of the hottest ring's temperature (K) and of its luminance
#endif
#ifdef BLOCK_SCREEN
    vec4 screen_real;  // G of observer/screen_form.h along the camera's right, up and forward, 0
    vec4 screen_imaginary;
#endif
#ifdef BLOCK_POLARISATION
    vec4 polarisation; // unit field in the matter's frame along r, theta and phi; polarised fraction, below 0: by scattering
#endif
#ifdef BLOCK_POLARISER
    vec4 polariser;    // cos and sin of twice its angle from the picture's right towards up; 0, 0
#endif
#ifdef BLOCK_POINT_STARS
    vec4 point_stars;  // peak of the point spread (1/px^2); for a star's reach: 2 sigma^2 ln 2 (px^2), 1/magnitude_limit light; margin (px)
    vec4 point_spread; // log2(e)/(2 sigma^2) (1/px^2), 0, 0, 0
#endif
#ifdef NEEDS_SAMPLING
    vec4 sampling;     // N x N rays a pixel: number of the first that is drawn, how many are; N; fetches of the sky for each, at most
#endif
#ifdef BLOCK_DITHER
    vec4 dither;       // where this part begins in the picture, px from the lower left corner, 0, 0
#endif
#ifdef BLOCK_BLOOM
    vec4 bloom;        // share of the light that is scattered, 0, 0, 0
#endif
#ifdef BLOCK_MARCH
    vec4 march;          // radius about the centre that holds all bodies (of a wormhole those on the near side), shortest step, the radius on the far side, the largest speed of a body
    vec4 march_shell;    // largest |z| and least radius of all bodies, wherever they move; of a hole the radius within which no ray on its way in meets one; that within which none that moves is seen
#endif
#ifdef BLOCK_DISC_PATTERN
    vec4 disc_material_map;     // as object/material.glsl has them
    vec4 disc_material_colour;
    vec4 disc_material_second;
#endif
#ifdef BLOCK_SKY_PATTERN
    vec4 sky_pattern_x;            // axes of the sky in world axes, .w = 0
    vec4 sky_pattern_y;
    vec4 sky_pattern_z;
    vec4 sky_pattern_map;          // as object/material.glsl has them, not turned
    vec4 sky_pattern_colour;
    vec4 sky_pattern_second;
#endif
#ifdef BLOCK_LIGHT_TIMES
    vec4 delay;        // x, y of A = (1 - x zeta)(1 - y zeta); the camera's part of light times, of rays to the sky and of others (planar/delay.glsl);
                       //   about a rotating hole r_* - r of the camera, 1 if it is far away, r_* + r, 2 r_* (mino/kerr.glsl).
                       //   Delays of places, and times that they are taken from, are less by the camera's r: from afar that has no digits left for them
#endif
#ifdef BLOCK_DISC_FLOW
    vec4 disc_winding; // scene time over the life of a copy, less its whole part; 1/life; Omega^2 = zeta^3 (z - w zeta)
    vec4 disc_copy;    // that whole part, modulo 4096; sense of the flow, 1 or -1 (object/disc_orbit.glsl); 0, 0
#endif
#ifdef BLOCK_RING_RATES
    vec4 disc_rate_span;   // of ln r: middle of the disc, 1 over half its width; 0, 0
    vec4 disc_rate_0;  // terms of the polynomial of object/disc_orbit.glsl, from the lowest
    vec4 disc_rate_1;
    vec4 disc_rate_2;
#endif
#ifdef BLOCK_DISC_GAS
    vec4 disc_gas;     // contrast; turns by which filaments trail for each unit of ln r; turns by which all is turned; time, r_s/c
    vec4 disc_gas_colour;   // and brightness; 0
#endif
#ifdef BLOCK_SPIN
    // Of a rotating hole (mino/trace.glsl): view directions, motion and ray_0, ray_x, ray_y are then along (e_r, e_theta, e_phi) of
    // the observer's own frame. Forms of the tangent of the ray traced backward, for unit frequency in that frame; n: view direction.
    vec4 spin_hole;    // a, a^2, radii of the outer and of the inner horizon
    vec4 spin_energy;  // E = x + y n_r + z n_phi; p_theta = w n_theta
    vec4 spin_across;  // L/sin(theta) = x + y n_r + z n_phi; of L/sin(theta) - a E sin(theta) = w + (spin_climb.w) n_phi
    vec4 spin_climb;   // d zeta/d tau = x + y n_r + z n_phi
    vec4 spin_place;   // sin(theta), cos(theta) (exactly 0 in the equatorial plane), cos(phi), sin(phi)
    vec4 spin_turn;    // ingoing azimuth less Boyer and Lindquist's at the camera (0 inside the horizon), a over the horizons' distance; (charge/2M)^2, that distance
#endif
#ifdef BLOCK_SPIN_RING
    vec4 ring_peak;    // peak of the ray at (x, y) px (observer/spin_ring.h): x + y x + z y + w x^2
    vec4 ring_peak_2;  //   + x xy + y y^2 + z x^3 + w x^2 y
    vec4 ring_peak_3;  //   + x x y^2 + y y^3; 1 where that is so, else 0; -1e30
#endif
#ifdef BLOCK_SPIN_NEAR
    vec4 spin_near;    // X_+ of the photon = x + y n_r + z n_phi (mino/near.glsl); 1 - r_-/r_+
    vec4 spin_near_2;  // 1/r_+ = x + y, x a float; 1 - r_+/r of the camera; -1e30
    vec4 spin_near_3;  // E, L/sin(theta), d zeta/d tau and X_+ at n_r = -1, n_phi = 0
#endif
#ifdef BLOCK_SIDES
    vec4 throat;       // radius of a wormhole's throat, mu of table/throat_orbit.h, 0, 0
#endif
#ifdef BLOCK_MEDIUM
    vec4 medium_hole;    // a, radii of the outer and of the inner horizon; the radius within which no matter is looked for
    vec4 medium_bound;   // radius beyond which there is none; of its march: least step, steps over what is enough; exposure by which
                         //   edges are found (effect/edge.glsl) where the picture is a flux, else 0
    vec4 medium_colour;  // factor on its light; what of the light behind comes through it where no more is looked for
    vec4 medium_law_0;   // of its emission law, by the names of kLawNumbers (src/plan/medium_model.h)
    vec4 medium_law_1;
    vec4 medium_law_2;
    vec4 medium_form_0;  // of its model, by the names of MediumModel::numbers
    vec4 medium_form_1;
    vec4 medium_form_2;
    vec4 medium_form_3;
    vec4 medium_form_4;
    vec4 medium_form_5;
#endif
#ifdef BLOCK_MEDIUM_BANDS
    vec4 medium_band_0;  // of each of several frequencies, by the names of kBandNumbers: red,
    vec4 medium_band_1;  //   green, of two frequencies blue,
    vec4 medium_band_2;  //   blue
#endif
};
