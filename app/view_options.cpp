#include "app/view_options.h"

namespace plumb::app {

void AddViewOptions(CLI::App& command, ViewOptions& view) {
    command.add_option("--camera", view.camera, "Name of the camera; the first if not given");
    AddPictureOptions(command, view);
}

void AddPictureOptions(CLI::App& command, ViewOptions& view) {
    command.add_option("--width", view.width_px, "Width of the picture [px]")
        ->check(CLI::Range(1, 16384));
    command.add_option("--height", view.height_px, "Height of the picture [px]")
        ->check(CLI::Range(1, 16384));
    command
        .add_option("--guard", view.guard_px,
                    "Border drawn around the picture but not shown [px]; not given: 128 px at "
                    "720 rows and in proportion")
        ->check(CLI::Range(0, 4096));
}

}  // namespace plumb::app
