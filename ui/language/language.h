// The language of what people see: English, or one that resources/translations has. Chosen by
// one thread, read by any at any time; what was made before keeps its words. Tables, scene
// files and lines on stderr are English whatever is chosen.
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

class QObject;

namespace asperity {

struct Language {
  std::string_view code;  // "de"
  std::string_view name;  // in itself: "Deutsch"
};

/// All of them; English first.
std::span<const Language> languages();

/// "en, de".
std::string languageCodes();

/// The code of a language that is there: "de" for "de", "de_AT" or "de-CH"; empty for any other.
std::string_view languageFor(std::string_view locale);

/// Chooses one of `languages()`; an unknown code means English. Where there is a QCoreApplication,
/// its tr() and the texts of Qt's own dialogs follow, and every widget gets a
/// QEvent::LanguageChange.
void useLanguage(std::string_view code);

/// Calls `say` now, and again whenever the language changes: `say` sets all texts of the widget
/// that come from tr(). A child of a widget may be given as well. GUI thread.
void keepTranslated(QObject& widget, std::function<void()> say);

/// The code of the one in use.
std::string_view presentLanguage();

/// The translation of a source text in one of the contexts of resources/translations; nothing in
/// English, or where there is none.
std::optional<QString> translationIn(const char* context, const char* english);

/// "0.5" as the language writes it: "0,5". Any text that has no point but in numbers.
std::string inLanguage(std::string number);
QString inLanguage(QString number);

}  // namespace asperity
