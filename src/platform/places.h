// Where things are on this system.
#pragma once
#include <filesystem>
#include <string>

namespace nullscope::platform {

std::filesystem::path program_file();  // that runs here; empty: the system does not say
// As a program's file is called: "nullscope", on Windows "nullscope.exe".
std::string program_name(const std::string& name);

// $XDG_CONFIG_HOME/nullscope and $XDG_STATE_HOME/nullscope, which are in ~/.config and ~/.local/state; on Windows nullscope in %APPDATA% and
// %LOCALAPPDATA%. Empty: there is no home. Nothing is made.
std::filesystem::path settings_folder();
std::filesystem::path state_folder();

// Whether PATH has such a program.
bool is_in_path(const std::string& program);

}  // namespace nullscope::platform
