/* Loaded before GLFW (LD_PRELOAD): a gamepad whose axes and pressed buttons are the numbers in the file $NULLSCOPE_TEST_PAD. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct State {
    unsigned char buttons[15];
    float axes[6];
};

int glfwGetGamepadState(int id, struct State* state) {
    const char* path = getenv("NULLSCOPE_TEST_PAD");
    FILE* file = id == 2 && path != NULL ? fopen(path, "r") : NULL;
    if (file == NULL) return 0;
    memset(state, 0, sizeof *state);
    int read = 0, button = 0;
    while (read < 6 && fscanf(file, "%f", &state->axes[read]) == 1) ++read;
    while (fscanf(file, "%d", &button) == 1 && button >= 0 && button < 15) state->buttons[button] = 1;
    fclose(file);
    return read == 6;
}
