#include "ui/gamepad/virtual_pad.h"

#include <SDL.h>

namespace kickstand::ui {

namespace {

constexpr double kFullWay = 32767;

}  // namespace

VirtualPad::VirtualPad(bool standard) {
    const SDL_JoystickType type =
        standard ? SDL_JOYSTICK_TYPE_GAMECONTROLLER : SDL_JOYSTICK_TYPE_FLIGHT_STICK;
    const int index = SDL_JoystickAttachVirtual(type, kAxes, kButtons, kHats);
    if (SDL_Joystick* joystick = index < 0 ? nullptr : SDL_JoystickOpen(index))
        id_ = SDL_JoystickInstanceID(joystick);
}

void VirtualPad::move(int axis, double to) {
    SDL_JoystickSetVirtualAxis(SDL_JoystickFromInstanceID(id_), axis, static_cast<Sint16>(to * kFullWay));
}

void VirtualPad::press(int button, bool down) {
    SDL_JoystickSetVirtualButton(SDL_JoystickFromInstanceID(id_), button, down ? SDL_PRESSED : SDL_RELEASED);
}

void VirtualPad::unplug() {
    if (!works()) return;
    SDL_Joystick* joystick = SDL_JoystickFromInstanceID(id_);
    for (int index = 0; index < SDL_NumJoysticks(); ++index) {
        if (SDL_JoystickGetDeviceInstanceID(index) != id_) continue;
        SDL_JoystickDetachVirtual(index);
        break;
    }
    SDL_JoystickClose(joystick);
    id_ = -1;
}

}  // namespace kickstand::ui
