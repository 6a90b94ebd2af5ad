#include "viewer/panel_system.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "viewer/theme.h"

namespace nullscope::viewer {

PanelSystem::PanelSystem(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

PanelSystem::~PanelSystem() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void PanelSystem::begin_frame() {
    const double scale = window_.content_scale(), ratio = window_.pixel_ratio();
    if (scale != content_scale_ || ratio != pixel_ratio_) {
        content_scale_ = scale, pixel_ratio_ = ratio;
        ImGui_ImplOpenGL3_DestroyDeviceObjects();  // made again, with the new font, by the next NewFrame
        apply_theme(scale, ratio);
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

}  // namespace nullscope::viewer
