#include "ui/gamepad/sdl_pads.h"

#include <algorithm>
#include <array>

#include <SDL.h>

namespace kickstand::ui {

namespace {

// A device may claim any number of inputs.
constexpr int kMostAxes = 16;
constexpr int kMostButtons = 48;
constexpr int kMostHats = 2;
constexpr std::array kHatDirections{SDL_HAT_UP, SDL_HAT_DOWN, SDL_HAT_LEFT, SDL_HAT_RIGHT};
constexpr int kGuidText = 33;

double part(Sint16 value) {
    return std::max(-1.0, value / 32767.0);
}

PadState controllerState(SDL_GameController* controller) {
    PadState state;
    for (int axis = 0; axis < SDL_CONTROLLER_AXIS_MAX; ++axis) {
        state.axes.push_back(
            part(SDL_GameControllerGetAxis(controller, static_cast<SDL_GameControllerAxis>(axis))));
    }
    for (int button = 0; button < SDL_CONTROLLER_BUTTON_MAX; ++button) {
        state.buttons.push_back(
            SDL_GameControllerGetButton(controller, static_cast<SDL_GameControllerButton>(button)) != 0);
    }
    return state;
}

PadState joystickState(SDL_Joystick* joystick) {
    PadState state;
    for (int axis = 0; axis < std::min(SDL_JoystickNumAxes(joystick), kMostAxes); ++axis)
        state.axes.push_back(part(SDL_JoystickGetAxis(joystick, axis)));
    for (int button = 0; button < std::min(SDL_JoystickNumButtons(joystick), kMostButtons); ++button)
        state.buttons.push_back(SDL_JoystickGetButton(joystick, button) != 0);
    // A hat is four buttons.
    for (int hat = 0; hat < std::min(SDL_JoystickNumHats(joystick), kMostHats); ++hat) {
        const Uint8 stands = SDL_JoystickGetHat(joystick, hat);
        for (const int direction : kHatDirections)
            state.buttons.push_back((stands & direction) != 0);
    }
    return state;
}

}  // namespace

/// One that is open.
class SdlPads::Pad {
  public:
    explicit Pad(int index)
        : controller_(SDL_IsGameController(index) != 0 ? SDL_GameControllerOpen(index) : nullptr),
          joystick_(controller_ != nullptr ? SDL_GameControllerGetJoystick(controller_)
                                           : SDL_JoystickOpen(index)) {
        if (joystick_ == nullptr) return;
        info_.id = SDL_JoystickInstanceID(joystick_);
        const char* name =
            controller_ != nullptr ? SDL_GameControllerName(controller_) : SDL_JoystickName(joystick_);
        if (name != nullptr) info_.name = name;
        std::array<char, kGuidText> guid{};
        SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(joystick_), guid.data(), kGuidText);
        info_.model = guid.data();
        info_.known = controller_ != nullptr;
    }
    ~Pad() {
        if (controller_ != nullptr) {
            SDL_GameControllerClose(controller_);
        } else if (joystick_ != nullptr) {
            SDL_JoystickClose(joystick_);
        }
    }
    Pad(const Pad&) = delete;
    Pad& operator=(const Pad&) = delete;

    bool isThere() const { return joystick_ != nullptr && SDL_JoystickGetAttached(joystick_) != 0; }
    const PadInfo& info() const { return info_; }
    PadState state() const {
        return controller_ != nullptr ? controllerState(controller_) : joystickState(joystick_);
    }

  private:
    SDL_GameController* controller_;
    SDL_Joystick* joystick_;
    PadInfo info_;
};

SdlPads::SdlPads() {
    // Whoever drives may look at another window: the shell decides what that means. Signals are the
    // program's.
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetMainReady();
    works_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    if (!works_) return;
    // States are asked for; a queue that nobody reads would only fill up.
    SDL_JoystickEventState(SDL_IGNORE);
    SDL_GameControllerEventState(SDL_IGNORE);
}

SdlPads::~SdlPads() {
    pads_.clear();
    if (works_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void SdlPads::update() {
    if (!works_) return;
    SDL_GameControllerUpdate();
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    std::erase_if(pads_, [](const auto& pad) { return !pad->isThere(); });
    for (int index = 0; index < SDL_NumJoysticks(); ++index) {
        const int id = SDL_JoystickGetDeviceInstanceID(index);
        const auto open =
            std::find_if(pads_.begin(), pads_.end(), [id](const auto& pad) { return pad->info().id == id; });
        if (open != pads_.end()) continue;
        auto pad = std::make_unique<Pad>(index);
        if (pad->isThere()) pads_.push_back(std::move(pad));
    }
}

std::vector<PadInfo> SdlPads::pads() const {
    std::vector<PadInfo> infos;
    for (const auto& pad : pads_)
        infos.push_back(pad->info());
    return infos;
}

std::optional<PadState> SdlPads::state(int id) const {
    for (const auto& pad : pads_) {
        if (pad->info().id == id) return pad->state();
    }
    return std::nullopt;
}

}  // namespace kickstand::ui
