#include "ui/window/main/window_language.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QLocale>
#include <QMenu>
#include <QSettings>
#include <utility>

#include "ui/language/language.h"
#include "ui/panels/number_text.h"

namespace asperity {

namespace {

struct WindowLanguage {
  Q_DECLARE_TR_FUNCTIONS(asperity::WindowLanguage)
};

const QString kKey = QStringLiteral("language");

/// Empty where none was chosen.
std::string_view remembered() {
  return languageFor(QSettings().value(kKey).toString().toStdString());
}

}  // namespace

std::string_view windowLanguage() {
  if (const std::string_view code = remembered(); !code.empty()) return code;
  for (const QString& locale : QLocale::system().uiLanguages())
    if (const std::string_view code = languageFor(locale.toStdString()); !code.empty()) return code;
  return "en";
}

void addLanguages(QMenu& menu, std::function<void()> changed) {
  QMenu* names = menu.addMenu(WindowLanguage::tr("&Language"));
  auto* group = new QActionGroup(names);
  const auto add = [&](const QString& name, const QString& code) {
    QAction* action = names->addAction(name);
    action->setObjectName("language:" + code);
    action->setCheckable(true);
    action->setChecked(code == fromUtf8(remembered()));
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, action, [code, changed] {
      code.isEmpty() ? QSettings().remove(kKey) : QSettings().setValue(kKey, code);
      if (windowLanguage() != presentLanguage()) changed();
    });
  };
  add(WindowLanguage::tr("As the desktop"), {});
  for (const Language& language : languages())
    add(fromUtf8(language.name), fromUtf8(language.code));
}

}  // namespace asperity
