// The window's language: remembered between runs, else the desktop's. GUI thread, after
// prepareApplication.
#pragma once

#include <functional>
#include <string_view>

class QMenu;

namespace asperity {

/// The code of the remembered language; else the desktop's first one that is there; else English.
std::string_view windowLanguage();

/// A submenu of all languages and the desktop's. What is chosen is remembered; `changed` is called
/// where the window is to have another language than the present one.
void addLanguages(QMenu& menu, std::function<void()> changed);

}  // namespace asperity
