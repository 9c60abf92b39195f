#include <inkedge/setting_table.h>
#include <inkedge/version.h>

#include "c/handles.h"

namespace inkedge::c {
namespace {

thread_local std::string lastMessage;

}  // namespace

inkedge_status fail(Error::Kind kind, const std::string& message) noexcept {
    try {
        lastMessage = message;
    } catch (const std::bad_alloc&) {
        lastMessage.clear();
    }
    return static_cast<inkedge_status>(kind);
}

}  // namespace inkedge::c

using namespace inkedge::c;

const char* inkedge_message() { return lastMessage.c_str(); }

const char* inkedge_version() {
    static const std::string version{inkedge::version()};
    return version.c_str();
}

inkedge_status inkedge_settings_create(inkedge_settings** settings) {
    return handOut(settings, [] { return new inkedge_settings; });
}

void inkedge_settings_free(inkedge_settings* settings) { delete settings; }

inkedge_status inkedge_set(inkedge_settings* settings, const char* name, const char* text) {
    return guarded([&] {
        inkedge::set(given(settings, "settings").value, &given(name, "name"), &given(text, "text"),
                     &given(name, "name"));
    });
}

const char* inkedge_get(inkedge_settings* settings, const char* name) {
    const char* text = nullptr;
    guarded([&] {
        inkedge_settings& of = given(settings, "settings");
        const inkedge::SettingDescription* const row = inkedge::findSetting(&given(name, "name"));
        if (row == nullptr)
            throw inkedge::Error{inkedge::Error::Kind::Usage, std::string{"there is no setting named '"} + name + "'"};
        of.text = row->get(of.value);
        text = of.text.c_str();
    });
    return text;
}

inkedge_status inkedge_set_preset(inkedge_settings* settings, const char* name) {
    return guarded([&] { inkedge::setPreset(given(settings, "settings").value, &given(name, "name"), "preset"); });
}

inkedge_status inkedge_read_config(inkedge_settings* settings, const char* file) {
    return guarded([&] { inkedge::readConfig(given(settings, "settings").value, &given(file, "file")); });
}
