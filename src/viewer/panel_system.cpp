#include "viewer/panel_system.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "annotate/lettering.h"
#include "studio/palette.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr const char* kShaderVersion = "#version 330 core";
constexpr float kFontSize = 15.0f;  // units of ImGui's coordinates at a content scale of 1

void load_font(double pixels) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    const auto file = sans_font_file();
    static constexpr ImWchar kLetters[] = {0x20, 0xff, 0x3bb, 0x3bb, 0};  // Latin, and wavelengths' lambda
    if (file && fonts.AddFontFromFileTTF(file->string().c_str(), static_cast<float>(std::round(pixels)), nullptr,
                                         kLetters) != nullptr)
        return;
    constexpr float kBitmapFont = 13.0f;  // sharp only in whole multiples
    ImFontConfig config;
    config.SizePixels = kBitmapFont * std::fmax(1.0f, std::round(static_cast<float>(pixels) / kBitmapFont));
    fonts.AddFontDefault(&config);
}

ImVec4 as_imgui(const Colour& c) { return {c.red, c.green, c.blue, c.opacity}; }

void colour(ImGuiStyle& style, const Palette& p) {
    if (&p == &light_palette())
        ImGui::StyleColorsLight(&style);
    else
        ImGui::StyleColorsDark(&style);
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = as_imgui(p.text);
    c[ImGuiCol_TextDisabled] = as_imgui(p.dim);
    c[ImGuiCol_WindowBg] = as_imgui(p.panel);
    c[ImGuiCol_MenuBarBg] = c[ImGuiCol_PopupBg] = as_imgui(p.panel.with(0.97f));
    c[ImGuiCol_Separator] = as_imgui(p.faint);
    c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = as_imgui(p.field);
    c[ImGuiCol_Border] = as_imgui(p.border);
    c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = c[ImGuiCol_HeaderHovered] = as_imgui(p.over);
    c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = c[ImGuiCol_HeaderActive] = as_imgui(p.held);
    c[ImGuiCol_Header] = as_imgui(p.header);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = as_imgui(p.title());
    c[ImGuiCol_CheckMark] = as_imgui(p.accent);
    constexpr float kGrab = 0.5f;  // so that the number over a slider's handle can be read
    c[ImGuiCol_PlotHistogram] = as_imgui(p.grab);
    c[ImGuiCol_SliderGrab] = as_imgui(p.grab.with(kGrab));
    c[ImGuiCol_SliderGrabActive] = as_imgui(p.dragged().with(kGrab));
    c[ImGuiCol_TextSelectedBg] = as_imgui(p.grab.with(0.35f));
    c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
    c[ImGuiCol_ResizeGrip] = {0, 0, 0, 0};
}

// Dear ImGui 1.86 keeps the undo stack of the last field of text for when it is entered again. By then the text may be another: to undo
// would write outside of it.
void forget_text_that_was_left() {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.ActiveId != context.InputTextState.ID) context.InputTextState.ID = 0;
}

// Fields of numbers leave out what is no part of one: of "12,5" they would take 125.
void take_decimal_commas() {
    if (types_number()) std::ranges::replace(ImGui::GetIO().InputQueueCharacters, ImWchar{','}, ImWchar{'.'});
}

// Sets style and fonts anew. content_scale: how much larger than usual, in framebuffer pixels; pixel_ratio: framebuffer
// pixels a unit of ImGui's coordinates. Only between frames.
void apply_theme(double content_scale, double pixel_ratio) {
    ImGuiStyle style;
    style.WindowRounding = 6.0f;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = 3.0f;
    style.ScrollbarRounding = 6.0f;
    style.ScrollbarSize = 10.0f;
    style.GrabMinSize = 9.0f;
    style.WindowPadding = {10.0f, 8.0f};
    style.FramePadding = {6.0f, 3.0f};
    style.ItemSpacing = {7.0f, 4.0f};
    style.ItemInnerSpacing = {5.0f, 4.0f};
    style.WindowBorderSize = style.PopupBorderSize = style.FrameBorderSize = 1.0f;
    colour(style, palette());
    style.ScaleAllSizes(static_cast<float>(content_scale / pixel_ratio));
    ImGui::GetStyle() = style;
    load_font(static_cast<double>(kFontSize) * content_scale);
    ImGui::GetIO().FontGlobalScale = static_cast<float>(1.0 / pixel_ratio);
}

#if IMGUI_VERSION_NUM < 18700
// That version sees which keys are down when a frame begins: a key that went down and up since the frame before would be lost.
void press_keys(const std::vector<KeyPress>& pressed) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
    for (const KeyPress& press : pressed) {
        io.KeysDown[press.key] = true;
        io.KeysDownDuration[press.key] = -1.0f;
        // With Ctrl no text is taken.
        io.KeyCtrl |= press.control && io.InputQueueCharacters.empty();
        io.KeyShift |= press.shift;
    }
}

void release_keys(const std::vector<KeyPress>& pressed, GLFWwindow* window) {
    for (const KeyPress& press : pressed)
        ImGui::GetIO().KeysDown[press.key] = glfwGetKey(window, press.key) == GLFW_PRESS;
}
#endif

}  // namespace

PanelSystem::PanelSystem(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init(kShaderVersion);
}

PanelSystem::~PanelSystem() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void PanelSystem::begin_frame(double text_scale, bool light, const std::vector<KeyPress>& pressed) {
    const double scale = text_scale * window_.content_scale(), ratio = window_.pixel_ratio();
    if (scale != content_scale_ || ratio != pixel_ratio_ || light != light_) {
        content_scale_ = scale, pixel_ratio_ = ratio, light_ = light;
        use_palette(light);
        ImGui_ImplOpenGL3_Shutdown();  // version 1.86 keeps the sizes of buffers that it destroys: so all of it anew
        apply_theme(scale, ratio);
        ImGui_ImplOpenGL3_Init(kShaderVersion);
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
#if IMGUI_VERSION_NUM < 18700
    press_keys(pressed);
    // There Enter alone presses no button.
    if (navigates() && glfwGetKey(window_.handle(), GLFW_KEY_ENTER) == GLFW_PRESS)
        ImGui::GetIO().NavInputs[ImGuiNavInput_Activate] = 1.0f;
#endif
    had_control_ = ImGui::IsAnyItemActive() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    ImGui::NewFrame();
#if IMGUI_VERSION_NUM < 18700
    release_keys(pressed, window_.handle());
#endif
    forget_text_that_was_left();
    take_decimal_commas();
    if (!enters_ || glfwGetKey(window_.handle(), GLFW_KEY_TAB) == GLFW_PRESS)
        return;  // Tab itself goes from field to field
    enters_ = false;
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::SetWindowFocus(kSideWindow);
}

bool PanelSystem::navigates() const { return (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0; }

void PanelSystem::navigate(bool on) {
    enters_ = on && !navigates();
    if (on || !navigates()) return;
    ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::SetWindowFocus(nullptr);
}

}  // namespace nullscope::viewer
