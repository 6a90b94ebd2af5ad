#!/usr/bin/env bash
# Builds nullscope.exe and nullscope-viewer.exe for Windows (x86-64, 10 and later) with Debian's mingw-w64, tests them under Wine, and packs them.
#
#   scripts/windows.sh [STEP...]      STEP: --libraries, --build, --test, --zip; all of them by default
#
# Libraries are built from the distribution's sources (apt-get source) into build/windows/prefix, once; everything is linked statically. It
# needs the packages g++-mingw-w64-x86-64-posix, libz-mingw-w64-dev, dpkg-dev and wine, to test xvfb and xdotool too, to pack zip: where one is missing, or the sources
# cannot be fetched, a line says so and the status is 0. Some 10 core-minutes for the libraries, 20 for the program.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=$repository/build/windows
case "${1-}" in -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;; esac
say() { echo "windows: $*" >&2; }
skip() { say "left out: $*"; exit 0; }
wanted() { [[ ${#steps[@]} -eq 0 || " ${steps[*]} " == *" --$1 "* ]]; }
steps=("$@")
for step in "${steps[@]}"; do
    [[ " --libraries --build --test --zip " == *" $step "* ]] || { say "unknown step $step; see --help"; exit 2; }
done

for tool in x86_64-w64-mingw32-g++-posix dpkg-source wine; do
    command -v "$tool" >/dev/null || skip "$tool is not installed: apt install g++-mingw-w64-x86-64-posix libz-mingw-w64-dev dpkg-dev wine"
done
export NULLSCOPE_WINDOWS_PREFIX=$folder/prefix WINEPREFIX=$folder/wine WINEDEBUG=-all
export PKG_CONFIG_LIBDIR=$folder/prefix/lib/pkgconfig
mkdir -p "$folder/sources/apt/lists/partial" "$folder/sources/apt/cache/archives/partial" "$folder/prefix"

# The source of a package, patched as the distribution does, or where that is not to be had as its authors released it.
sources=(-o Dir::Etc::SourceList="$folder/sources/list" -o Dir::Etc::SourceParts=- -o Dir::State::Lists="$folder/sources/apt/lists"
         -o Dir::Cache="$folder/sources/apt/cache" -o APT::Sandbox::User=root)
source_of() {
    local package=$1 place=$folder/sources/$1
    [[ -e $place/tree ]] && return
    rm -rf "$place" && mkdir -p "$place"
    if [[ ! -e $folder/sources/list ]]; then
        . /etc/os-release
        for suite in "$VERSION_CODENAME ${MIRROR:-http://deb.debian.org/debian}" "$VERSION_CODENAME-security ${MIRROR:-http://deb.debian.org/debian}-security"; do
            echo "deb-src ${suite#* } ${suite% *} main"
        done >"$folder/sources/list"
        apt-get "${sources[@]}" update >"$folder/sources/apt.log" 2>&1 || { rm "$folder/sources/list"; skip "the list of sources cannot be had"; }
    fi
    (cd "$place" && apt-get "${sources[@]}" source --download-only "$package" >>"$folder/sources/apt.log" 2>&1) || true
    if ! (cd "$place" && dpkg-source --no-check -x ./*.dsc tree >/dev/null 2>&1); then
        ls "$place"/*.orig.tar.* >/dev/null 2>&1 || skip "the source of $package cannot be had"
        say "$package without the distribution's patches, which cannot be had"
        rm -rf "$place/tree"
        mkdir "$place/unpacked" && tar -xf "$place"/*.orig.tar.[bgx]z* -C "$place/unpacked" && mv "$place"/unpacked/* "$place/tree"
    fi
}

# library PACKAGE OPTION...: what its CMake installs, once.
library() {
    local package=$1 done=$folder/prefix/$1.whole
    shift
    [[ -e $done ]] && return
    say "the library $package"
    source_of "$package"
    cmake -G Ninja -S "$folder/sources/$package/tree" -B "$folder/sources/$package/build" --toolchain "$repository/scripts/windows.cmake" \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_{C,CXX}_FLAGS_RELEASE="-O2 -DNDEBUG" -DCMAKE_INSTALL_PREFIX="$folder/prefix" -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF \
        "$@" >"$folder/sources/$package.log" 2>&1 &&
        cmake --build "$folder/sources/$package/build" --target install >>"$folder/sources/$package.log" 2>&1 ||
        { tail -n 20 "$folder/sources/$package.log" >&2; exit 1; }
    touch "$done"
}

# Dear ImGui has no build of its own: as the distribution packs it, without its FreeType.
imgui() {
    [[ -e $folder/prefix/imgui.whole ]] && return
    say "the library imgui"
    source_of imgui
    local tree=$folder/sources/imgui/tree file
    mkdir -p "$folder/sources/imgui/build" "$folder/prefix/include/imgui/backends"
    for file in "$tree"/imgui*.cpp "$tree"/misc/cpp/imgui_stdlib.cpp "$tree"/backends/imgui_impl_{glfw,opengl3}.cpp; do
        x86_64-w64-mingw32-g++-posix -O2 -DNDEBUG -fno-ipa-ra -fvisibility=hidden -I"$tree" -I"$folder/prefix/include" -c "$file" \
            -o "$folder/sources/imgui/build/$(basename "$file" .cpp).o" >>"$folder/sources/imgui.log" 2>&1 || { tail -n 20 "$folder/sources/imgui.log" >&2; exit 1; }
    done
    x86_64-w64-mingw32-ar rcs "$folder/prefix/lib/libimgui.a" "$folder"/sources/imgui/build/*.o
    cp "$tree"/{imgui,imgui_internal,imconfig,imstb_rectpack,imstb_textedit,imstb_truetype}.h "$tree"/misc/cpp/imgui_stdlib.h "$folder/prefix/include/imgui"
    cp "$tree"/backends/imgui_impl_{glfw,opengl3,opengl3_loader}.h "$folder/prefix/include/imgui/backends"
    printf 'Name: imgui\nDescription: Dear ImGui\nVersion: 1.86\nLibs: -L%s -limgui -limm32\nCflags: -I%s\n' "$folder/prefix/lib" "$folder/prefix/include/imgui" \
        >"$folder/prefix/lib/pkgconfig/imgui.pc"
    touch "$folder/prefix/imgui.whole"
}

if wanted libraries; then
    # Headers alone are the same everywhere; with them go the files by which CMake finds them.
    mkdir -p "$folder/prefix/include" "$folder/prefix/share/cmake" "$folder/prefix/lib/pkgconfig"
    for headers in boost CLI eigen3 fast_float glm nlohmann stb toml++; do
        [[ -e /usr/include/$headers ]] || skip "/usr/include/$headers is missing: scripts/install-packages.sh"
        ln -sfn "/usr/include/$headers" "$folder/prefix/include/$headers"
    done
    cp -r /usr/share/cmake/{CLI11,glm,nlohmann_json} "$folder/prefix/share/cmake"
    cp -r /usr/share/eigen3 "$folder/prefix/share"
    ln -sfn /usr/x86_64-w64-mingw32/include/zlib.h /usr/x86_64-w64-mingw32/include/zconf.h "$folder/prefix/include"
    cp -u /usr/x86_64-w64-mingw32/lib/libz.a "$folder/prefix/lib"
    # The distribution's own file asks for the shared library.
    mkdir -p "$folder/prefix/lib/cmake/tomlplusplus"
    printf 'add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED)\nset_target_properties(tomlplusplus::tomlplusplus PROPERTIES INTERFACE_INCLUDE_DIRECTORIES %s)\n' \
        "$folder/prefix/include" >"$folder/prefix/lib/cmake/tomlplusplus/tomlplusplusConfig.cmake"
    library fmtlib -DFMT_TEST=OFF -DFMT_DOC=OFF
    library libjpeg-turbo -DENABLE_SHARED=OFF -DWITH_SIMD=OFF -DWITH_TURBOJPEG=OFF
    library libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF
    library tiff -Dtiff-tools=OFF -Dtiff-tests=OFF -Dtiff-docs=OFF -Dtiff-contrib=OFF -Dlzma=OFF -Dzstd=OFF -Dwebp=OFF -Djbig=OFF -Dlerc=OFF -Dlibdeflate=OFF -Dcxx=OFF
    library freetype -DFT_REQUIRE_ZLIB=ON -DFT_DISABLE_{BZIP2,PNG,HARFBUZZ,BROTLI}=ON
    library cfitsio -DUSE_CURL=OFF
    library imath
    library openexr -DOPENEXR_BUILD_TOOLS=OFF -DOPENEXR_INSTALL_EXAMPLES=OFF -DOPENEXR_INSTALL_TOOLS=OFF
    # Threads of TBB take on the rounding of the thread that gives them work, and on Linux the precision of its long double; Windows begins a thread with
    # 53 bits. Of its two ways to do so the one in assembler sets both; Microsoft's function, for which alone the other is meant, leaves the precision.
    source_of onetbb
    settings=$folder/sources/onetbb/tree/include/oneapi/tbb/detail/_machine.h
    if grep -q '^#if (_WIN32)$' "$settings"; then
        sed -i 's/^#if (_WIN32)$/#if (_MSC_VER)/' "$settings"
        rm -f "$folder/prefix/onetbb.whole"
    fi
    library onetbb -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF
    # Fits are of a few numbers: Eigen's dense matrices will do.
    library ceres-solver -DMINIGLOG=ON -DGFLAGS=OFF -DLAPACK=OFF -DSUITESPARSE=OFF -DCXSPARSE=OFF -DEIGENSPARSE=OFF -DCUDA=OFF -DSCHUR_SPECIALIZATIONS=OFF \
        -DBUILD_{EXAMPLES,BENCHMARKS}=OFF
    library glfw3 -DGLFW_BUILD_{EXAMPLES,TESTS,DOCS}=OFF
    imgui
fi

if wanted build; then
    say "building"
    cmake -G Ninja -S "$repository" -B "$folder/build" --toolchain "$repository/scripts/windows.cmake" -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" -DNULLSCOPE_UNITY=ON -DNULLSCOPE_TESTS=OFF \
        >"$folder/configure.log" || { tail -n 20 "$folder/configure.log" >&2; exit 1; }
    cmake --build "$folder/build" --target nullscope nullscope-viewer
fi
if wanted test; then
    # For the film: PyPI has it for Windows. Where it cannot be had, that test says so.
    if [[ ! -e $folder/ffmpeg/ffmpeg.exe ]]; then
        rm -rf "$folder/ffmpeg" && mkdir "$folder/ffmpeg"
        python3 -m pip download --quiet --no-deps --only-binary=:all: --platform win_amd64 --dest "$folder/ffmpeg" imageio-ffmpeg==0.6.0 >/dev/null 2>&1 &&
            unzip -q -j "$folder"/ffmpeg/*.whl '*.exe' -d "$folder/ffmpeg" && mv "$folder"/ffmpeg/*.exe "$folder/ffmpeg/ffmpeg.exe" || say "no ffmpeg.exe"
    fi
    here=$repository/build/release/bin/nullscope
    [[ -x $here ]] || skip "there is no $here to compare with: scripts/build.sh"
    for test in "test_windows.py $here" test_viewer.py; do
        result=0
        python3 -B "$repository/tests/windows/"$test || result=$?
        [[ $result -eq 0 || $result -eq 77 ]] || exit "$result"   # 77: left out, and it said why
    done
fi

if wanted zip; then
    command -v zip >/dev/null || skip "zip is not installed"
    version=$(sed -n 's/^CMAKE_PROJECT_VERSION:[A-Z]*=//p' "$folder/build/CMakeCache.txt")
    name=nullscope-$version-windows-x86_64
    rm -rf "$folder/zip" "$folder/$name.zip"
    mkdir -p "$folder/zip/$name/share/doc/libraries"
    for program in nullscope.exe nullscope-viewer.exe nullscope-programs.dll; do
        x86_64-w64-mingw32-strip -o "$folder/zip/$name/$program" "$folder/build/bin/$program"
        # Nothing that Windows itself does not bring, but the library that both programs are in.
        x86_64-w64-mingw32-objdump -p "$folder/zip/$name/$program" | sed -n 's/^\tDLL Name: //p' | tr '\n' ' ' | sed "s/^/$program imports /;s/\$/\n/"
    done
    mkdir -p "$folder/zip/$name/share/nullscope"
    cp -r "$repository/assets/." "$folder/zip/$name/share/nullscope"
    cp "$repository/LICENSE" "$folder/zip/$name/share/doc"
    cp "$repository/README.md" "$folder/zip/$name/share/doc"
    for package in "$folder"/sources/*/tree; do   # what is linked in, each under its own licence
        text=$(find "$package/debian/copyright" "$package" -maxdepth 2 -type f \( -name copyright -o -iname 'licen[cs]e*' -o -iname 'copying*' \) -print -quit 2>/dev/null || true)
        [[ -n $text ]] || { say "no licence of $package"; exit 1; }
        cp "$text" "$folder/zip/$name/share/doc/libraries/$(basename "$(dirname "$package")")"
    done
    # And libraries of headers alone, by their packages.
    headers=$(dpkg-query --search /usr/include/{CLI/CLI.hpp,boost/version.hpp,eigen3/Eigen/Core,fast_float/fast_float.h,glm/glm.hpp,nlohmann/json.hpp,stb/stb_image.h,toml++/toml.h} |
        sed 's/:.*//')
    for package in libz-mingw-w64-dev mingw-w64-common $headers; do
        cp "/usr/share/doc/$package/copyright" "$folder/zip/$name/share/doc/libraries/$package"
    done
    # For who unpacks it, in the lines of Windows; SmartScreen's words are Microsoft's.
    sed 's/$/\r/' >"$folder/zip/$name/README.txt" <<EOF
nullscope $version: curved spacetimes, seen from within.

Start nullscope-viewer.exe in this folder. Nobody has signed the programs: where SmartScreen
stops the first start, choose "More info", then "Run anyway".

For pictures, films and tables there is nullscope.exe, in a terminal in this folder:

    nullscope.exe capture first-light -o first-light.png
    nullscope.exe --help

More, and all that one can ask of it: share\doc\README.md. Licences: share\doc.
EOF
    if [[ -n ${SOURCE_DATE_EPOCH-} ]]; then find "$folder/zip" -exec touch -d "@$SOURCE_DATE_EPOCH" {} +; fi
    (cd "$folder/zip" && TZ=UTC zip -q -9 -X -r "../$name.zip" "$name")
    size=$(stat -c %s "$folder/$name.zip")
    say "$folder/$name.zip, $((size / 1000)) kB"
    ((size <= 15000000)) || { say "more than 15 MB"; exit 1; }
fi
