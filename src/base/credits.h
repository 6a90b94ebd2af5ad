// Whose data ship with the program: assets/sky/README.md and assets/images/README.md say more.
#pragma once

namespace nullscope {

inline constexpr const char* kCredits =
    R"(Milky Way: all-sky panorama by Axel Mellinger, University of Potsdam, as it comes with Stellarium 0.22.2 (Debian package stellarium-data);
    permission given to "modify and redistribute this image if proper credit to the original image is given". Changed here: turned to
    another origin, bright stars taken out, brightness and colours calibrated. http://home.arcor-online.de/axel.mellinger/
Stars: XHIP, An Extended Hipparcos Compilation, E. Anderson and C. Francis (2012), Astronomy Letters 38, 331 (VizieR V/137D), after
    the Hipparcos catalogue, ESA (1997), SP-1200; by way of d3-celestial 0.7.35, (c) 2015 Olaf Frohn, BSD 3-Clause,
    https://github.com/ofrohn/d3-celestial (its licence: LICENSE-d3-celestial.txt beside the data).
Earth: Blue Marble Next Generation with topography and bathymetry, Reto Stöckli, NASA Earth Observatory (public domain); by way of the npm
    package three-globe 2.45.2.
The disc's picture and all else: part of nullscope, MIT.)";

}  // namespace nullscope
