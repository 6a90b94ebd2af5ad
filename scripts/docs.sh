#!/usr/bin/env bash
# Builds the documentation as a site: build/site, a folder that any web server can serve and any browser opens from disk (but
# for its search, which browsers allow from a server only).
#
#   scripts/docs.sh            builds it; installs mkdocs by apt if it is missing
#   scripts/docs.sh --serve    and serves it to this machine, port 8001
#
# Its pages are docs/, CONTRIBUTING.md and CHANGELOG.md; mkdocs.yml has the menu. Every warning is an error.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case "${1-}" in
    "" | --serve) ;;
    -h | --help) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 0 ;;
    *) sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac

"$root/scripts/install-packages.sh" --quiet --docs
pages=$root/build/docs
rm -rf "$pages"
mkdir -p "$pages"
cp -r "$root/docs/." "$pages"
cp "$root/CONTRIBUTING.md" "$root/CHANGELOG.md" "$root/CITATION.cff" "$root/third_party/versions.md" "$pages"
cp -r "$root/assets/gallery" "$root/scripts/farm" "$root/scripts/blender" "$root/python/examples" "$pages"
# Links between the repository's folders, which are one folder here.
find "$pages" -name '*.md' -exec sed -i -e 's,\(\](\|src="\)\.\./assets/,\1,' -e 's,](\.\./\(scripts\|python\)/,](,g' \
    -e 's,](\.\./\([A-Z][A-Z]*\.\),](\1,g' -e 's,](docs/,](,g' {} +
(cd "$root" && mkdocs build --quiet --strict --clean)
# Debian 12's theme asks for a jQuery by another name than it brings, and without it has no menu on narrow screens.
jquery=$root/build/site/$(sed -n 's,.*src="\(js/jquery[^"]*\)".*,\1,p' "$root/build/site/index.html")
[[ -f $jquery ]] || cp "${jquery%/*}"/jquery*.js "$jquery"
echo "the documentation: $root/build/site/index.html ($(du -sh "$root/build/site" | cut -f1)); its search needs a server: --serve"
[[ ${1-} != --serve ]] || exec python3 -m http.server --bind 127.0.0.1 --directory "$root/build/site" 8001
