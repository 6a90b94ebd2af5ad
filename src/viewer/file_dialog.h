// The desktop's own dialog to choose a file, in a process of its own: the window answers meanwhile.
#pragma once
#include <string>

#include "base/result.h"
#include "studio/child_process.h"

namespace nullscope::viewer {

class FileDialog {
public:
    static bool available();  // zenity (GNOME and others) or kdialog (KDE) is installed
    Status open();            // asks for a scene file. Errors: it cannot be started
    bool runs() const { return process_.runs(); }
    std::string poll();  // the file that was chosen, once; "": none, or not yet

private:
    ChildProcess process_;
};

}  // namespace nullscope::viewer
