#include "viewer/panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "viewer/panel_rows.h"

namespace nullscope::viewer {

std::span<const Panel* const> panels() { return kPanelRows; }

void set_open(ViewState& view, const Panel& panel, bool open) {
    if (open)
        view.panels.insert(panel.name);
    else
        view.panels.erase(panel.name);
}

bool docked(const ViewState& view) { return is_open(view, kSidePanel); }

bool close_topmost_panel(ViewState& view) {
    const auto list = panels();
    const auto last = std::find_if(list.rbegin(), list.rend(),
                                   [&](const Panel* panel) { return panel->escapes && is_open(view, *panel); });
    if (last == list.rend()) return false;
    set_open(view, **last, false);
    return true;
}

void close_for_tour(ViewState& view) {
    for (const Panel* panel : panels())
        if (panel->hides_picture) set_open(view, *panel, false);
}

void draw_panels(PanelPlace& place, bool over) {
    for (const Panel* panel : panels()) {
        if ((panel->where == Panel::Where::kOver) != over) continue;
        const bool wanted = is_open(place.view, *panel) || (panel->needed != nullptr && panel->needed(place));
        if (!wanted || (panel->where == Panel::Where::kDocked && !docked(place.view))) {
            place.parts.kept.erase(panel);
            if (panel->forget != nullptr) panel->forget(place.parts);
            continue;
        }
        place.open = true;
        place.kept = &place.parts.kept[panel];
        panel->draw(place);
        if (!place.open) set_open(place.view, *panel, false);
    }
}

std::string spaced(const char* keys) {
    std::string words;
    for (const char* at = keys; *at != '\0'; ++at)
        if (*at == '+' && at != keys)
            words += " + ";
        else
            words += *at;
    return words;
}

std::string panel_help() {
    std::string text;
    for (const Panel* panel : panels())
        text += fmt::format("  {:<20}{:<10}{}\n", panel->name, panel->keys, panel->words);
    return text;
}

}  // namespace nullscope::viewer
