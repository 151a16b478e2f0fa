#include "ui/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <array>
#include <memory>

// Outside of the namespace, as the resource compiler's function is.
static void openResources() {
  Q_INIT_RESOURCE(asperity_translations);
}

namespace asperity {
namespace {

constexpr std::array<Language, 2> kLanguages{{{"en", "English"}, {"de", "Deutsch"}}};

struct Present {
  std::string_view code = "en";
  std::unique_ptr<QTranslator> texts, dialogs;  // ours and Qt's own; none for English
  bool hasComma = false;                        // in numbers
};

Present& present() {
  static Present present;
  return present;
}

std::unique_ptr<QTranslator> loaded(const QString& name, const QString& folder) {
  auto translator = std::make_unique<QTranslator>();
  return translator->load(name, folder) ? std::move(translator) : nullptr;
}

QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

}  // namespace

std::span<const Language> languages() {
  return kLanguages;
}

std::string languageCodes() {
  std::string codes;
  for (const Language& language : kLanguages)
    codes += (codes.empty() ? "" : ", ") + std::string(language.code);
  return codes;
}

std::string_view languageFor(std::string_view locale) {
  const std::string_view code = locale.substr(0, locale.find_first_of("_-.@"));
  const auto found = std::ranges::find(kLanguages, code, &Language::code);
  return found == kLanguages.end() ? std::string_view{} : found->code;
}

void useLanguage(std::string_view code) {
  Present next;
  if (const std::string_view known = languageFor(code); !known.empty()) next.code = known;
  const QString name = text(next.code);
  if (next.code != "en") {
    openResources();
    next.texts = loaded("asperity_" + name, QStringLiteral(":/asperity/translations"));
    next.dialogs = loaded("qtbase_" + name, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  }
  const QLocale locale(next.code == "en" ? QLocale::c() : QLocale(name));
  next.hasComma = locale.decimalPoint() == QStringLiteral(",");
  // A translator that goes away takes itself off the application.
  present() = std::move(next);
  QLocale::setDefault(locale);
  if (!QCoreApplication::instance()) return;
  for (const auto* translator : {&present().dialogs, &present().texts})
    if (*translator) QCoreApplication::installTranslator(translator->get());
}

std::string_view presentLanguage() {
  return present().code;
}

std::optional<QString> translationIn(const char* context, const char* english) {
  const QTranslator* texts = present().texts.get();
  if (!texts) return {};
  const QString found = texts->translate(context, english);
  return found.isEmpty() ? std::nullopt : std::optional(found);
}

std::string inLanguage(std::string number) {
  if (present().hasComma) std::ranges::replace(number, '.', ',');
  return number;
}

QString inLanguage(QString number) {
  return present().hasComma ? number.replace('.', ',') : number;
}

}  // namespace asperity
