#include "ui/window/import/material_import.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/regular_file.h"
#include "core/chart/material_sheets.h"
#include "core/material/material_summary.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/panels/panel_style.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/file_dialogs.h"

namespace asperity {

/// The result of reading the file in the background.
struct MaterialImport::Preview {
  std::shared_ptr<const std::string> bytes{};
  std::shared_ptr<const Material> material{};
  std::optional<std::pair<std::string, Message>> fault{};  // option, which may be empty
};

namespace {

constexpr std::size_t kLargestFile = std::size_t{64} << 20;  // bytes of measurements

/// An option of `asperity material` and its value, as the origin of the material keeps it.
using Written = std::vector<std::pair<std::string, std::string>>;

double kelvins(const QString& text, const char* option) {
  bool hasNoUnit = false;
  (void)withoutGroups(text.trimmed()).toDouble(&hasNoUnit);
  if (hasNoUnit)  // the page shows degrees Celsius, the command takes kelvins
    throw InputError(
        "", option,
        message("'{}' has no unit; write \u00B0C, K or \u00B0F after it", text.toStdString()));
  const auto temperature = parseTemperature(withoutGroups(text.trimmed()).toStdString());
  if (!temperature || !(*temperature > 0 && *temperature <= 2000))
    throw InputError("", option,
                     message("'{}' is not a temperature such as 20 \u00B0C, 293.15 K or 68 \u00B0F",
                             text.toStdString()));
  return *temperature;
}

/// A modulus in Pa, or with a unit.
double pascals(const QString& text, const char* option) {
  bool isNumber = false;
  const double value =
      toPlainNumber(withoutGroups(text), NumberRule{QStringLiteral("Pa")}).toDouble(&isNumber);
  if (!isNumber || !(value > 0) || !std::isfinite(value))
    throw InputError("", option,
                     message("'{}' is not a modulus such as 2.3MPa", text.toStdString()));
  return value;
}

QString askForMaterial(QWidget* parent, const QString& proposed) {
  return askSaveFile(parent, MaterialImport::tr("Save material"), proposed,
                     MaterialImport::tr("Materials (*.json)"));
}

}  // namespace

MaterialImport::MaterialImport(const QString& file, const Theme& theme, QWidget* parent)
    : ImportPage(file, tr("&Save and use…"), parent),
      chooser_(askForMaterial),
      sheet_(named<DiagramView>("dmaSheet")),
      sheets_(named<QTabBar>("dmaSheets")),
      warnings_(warningTextLabel("dmaWarnings")),
      summary_(textLabel("dmaSummary")) {
  setObjectName("materialImport");
  setWindowTitle(tr("Open material"));
  buildViews(theme);
  buildChoices();
  restart();
}

void MaterialImport::buildViews(const Theme& theme) {
  sheets_->setDrawBase(false);
  sheets_->setExpanding(false);
  sheets_->setUsesScrollButtons(true);
  connect(sheets_, &QTabBar::currentChanged, this, &MaterialImport::showSheet);
  sheet_->setTheme(theme);
  sheet_->setAccessibleName(tr("the measured moduli and their fit"));
  auto* texts = new QWidget;
  auto* column = marginless<QVBoxLayout>(texts, 4);
  for (QLabel* text : {warnings_, summary_}) column->addWidget(text);
  column->addStretch(1);
  warnings_->hide();
  auto* scroll = scrolled(texts, Qt::ScrollBarAlwaysOff);
  scroll->setFixedHeight(8 * fontMetrics().lineSpacing());
  scroll->setAccessibleName(tr("summary of the material"));
  views().addWidget(sheets_);
  views().addWidget(sheet_, 1);
  views().addWidget(scroll);
}

QLineEdit* MaterialImport::addEntry(QFormLayout& form, const char* option, const char* name,
                                    const QString& label, const QString& tip) {
  auto* entry = named<QLineEdit>(name);
  entry->setToolTip(tip);
  entry->setAccessibleName(label);
  connect(entry, &QLineEdit::editingFinished, this, [this, entry] {
    if (!entry->isModified()) return;
    entry->setModified(false);
    restart();
  });
  form.addRow(label, entry);
  if (option) controls_.emplace_back(option, entry);
  return entry;
}

QComboBox* MaterialImport::addChoice(QFormLayout& form, const char* option, const char* name,
                                     const QString& label, const QString& tip,
                                     const QString& automatic, const QStringList& words) {
  auto* box = named<ChoiceBox>(name);
  box->setToolTip(tip);
  box->setAccessibleName(label);
  box->addItem(automatic, QString());
  for (const QString& word : words) box->addItem(wordText(word.toStdString()), word);
  connect(box, &QComboBox::activated, this, [this] { restart(); });
  form.addRow(label, box);
  controls_.emplace_back(option, box);
  return box;
}

QCheckBox* MaterialImport::addCheck(QFormLayout& form, const char* option, const char* name,
                                    const QString& label) {
  auto* box = named<QCheckBox>(name, label);
  box->setAccessibleName(label);
  connect(box, &QCheckBox::toggled, this, [this] { restart(); });
  form.addRow(QString(), box);
  controls_.emplace_back(option, box);
  return box;
}

namespace {

void addHeading(QFormLayout& form, const QString& text) {
  form.addRow(new QLabel("<b>" + text + "</b>"));
}

}  // namespace

void MaterialImport::buildChoices() {
  auto* content = new QWidget;
  auto* form = marginless<QFormLayout>(content);
  form->setVerticalSpacing(5);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  addMeasurement(*form);
  addColumns(*form);
  addMasterCurve(*form);
  addSeries(*form);
  addHeading(*form, tr("The material file"));
  name_ = addEntry(*form, nullptr, "dmaName", tr("name"), tr("Name of the material"));
  name_->setPlaceholderText(QFileInfo(file()).completeBaseName());
  source_ = addEntry(*form, nullptr, "dmaSource", tr("source"),
                     tr("Where the measurements come from, so that a reader can look it up"));
  auto* scroll = scrolled(content, Qt::ScrollBarAlwaysOff);
  scroll->setObjectName("dmaChoices");
  scroll->setFocusPolicy(Qt::NoFocus);  // its controls take the focus
  constexpr int kMinWidth = 330;
  scroll->setFixedWidth(std::max(kMinWidth, content->minimumSizeHint().width() +
                                                scroll->verticalScrollBar()->sizeHint().width()));
  content->setObjectName("parameterRows");
  scroll->setStyleSheet(panelStyleSheet(palette()));
  halves().addWidget(scroll);
}

void MaterialImport::addMeasurement(QFormLayout& form) {
  const QString fromFile = tr("from the file");
  addHeading(form, tr("The measurement"));
  frequencyUnit_ = addChoice(form, "--frequency-unit", "dmaFrequencyUnit", tr("unit of frequency"),
                             tr("Unit of the frequencies"), fromFile, {"Hz", "rad/s"});
  temperatureUnit_ =
      addChoice(form, "--temperature-unit", "dmaTemperatureUnit", tr("unit of temperature"),
                tr("Unit of the temperatures"), fromFile, {"C", "K", "F"});
  modulusUnit_ = addChoice(form, "--modulus-unit", "dmaModulusUnit", tr("unit of modulus"),
                           tr("Unit of the moduli"), fromFile, {"Pa", "kPa", "MPa", "GPa"});
  modulus_ = addChoice(form, "--modulus", "dmaModulus", tr("kind of modulus"),
                       tr("Whether the moduli are of shear (G) or of tension (E)"), fromFile,
                       {"shear", "tension"});
  poisson_ = addEntry(form, "--poisson-ratio", "dmaPoisson", tr("Poisson's ratio"),
                      tr("Turns moduli of tension into those of shear: G = E / (2 (1 + ν))"));
  poisson_->setPlaceholderText(inLanguage(QStringLiteral("0.5")));
  temperature_ = addEntry(form, "--temperature", "dmaTemperature", tr("test temperature"),
                          tr("Temperature of a file that does not state one, such as 20 °C"));
  temperature_->setPlaceholderText(fromFile);
  instantaneous_ =
      addEntry(form, "--instantaneous-modulus", "dmaInstantaneous", tr("instantaneous modulus G₀"),
               tr("Shear modulus in Pa or MPa of a series that gives parts of it"));
  instantaneous_->setPlaceholderText(fromFile);
}

void MaterialImport::addColumns(QFormLayout& form) {
  addHeading(form, tr("Columns of the table"));
  const QString column = tr("Name of the column, or its number from 1 on");
  for (const auto& [entry, option, name, label] :
       std::initializer_list<std::tuple<QLineEdit**, const char*, const char*, QString>>{
           {&frequencyColumn_, "--frequency-column", "dmaFrequencyColumn", tr("frequency column")},
           {&temperatureColumn_, "--temperature-column", "dmaTemperatureColumn",
            tr("temperature column")},
           {&storageColumn_, "--storage-column", "dmaStorageColumn", tr("storage modulus column")},
           {&lossColumn_, "--loss-column", "dmaLossColumn", tr("loss modulus column")},
           {&lossTangentColumn_, "--tan-delta-column", "dmaLossTangentColumn",
            tr("loss tangent column")}}) {
    *entry = addEntry(form, option, name, label, column);
    (*entry)->setPlaceholderText(tr("found by its name"));
  }
}

void MaterialImport::addMasterCurve(QFormLayout& form) {
  addHeading(form, tr("Master curve"));
  reference_ =
      addEntry(form, "--reference-temperature", "dmaReference", tr("reference temperature"),
               tr("Temperature to which all isotherms are shifted, such as 20 °C"));
  reference_->setPlaceholderText(tr("near 25 °C"));
  vertical_ = addCheck(form, "--vertical-shifts", "dmaVertical", tr("vertical shifts, too"));
  shift_ = addChoice(form, "--shift", "dmaShift", tr("temperature shift"),
                     tr("How the material keeps the shifts with temperature: by the formula of "
                        "Williams, Landel and Ferry, by that of Arrhenius, or as their table"),
                     tr("automatic"), {"wlf", "arrhenius", "table"});
}

void MaterialImport::addSeries(QFormLayout& form) {
  addHeading(form, tr("Prony series"));
  terms_ = named<SpinBox>("dmaTerms");
  terms_->setRange(0, kMaxTerms);
  terms_->setSpecialValueText(tr("as few as needed"));
  terms_->setToolTip(tr("Relaxation times, evenly spaced in their logarithm"));
  terms_->setAccessibleName(tr("number of terms"));
  connect(terms_, &QSpinBox::valueChanged, this, [this] { restart(); });
  form.addRow(tr("number of terms"), terms_);
  controls_.emplace_back("--terms", terms_);
  equilibrium_ =
      addEntry(form, "--equilibrium-modulus", "dmaEquilibrium", tr("equilibrium modulus G∞"),
               tr("Shear modulus in Pa or MPa where it is known from elsewhere"));
  equilibrium_->setPlaceholderText(tr("from the fit"));
  liquid_ = addCheck(form, "--liquid", "dmaLiquid", tr("allow G∞ = 0 (a liquid)"));
  liquid_->setToolTip(tr("Whether the material may flow, without an equilibrium modulus"));
}

/// Returns the present choices. Throws InputError (option) where an entry is invalid.
MaterialChoices MaterialImport::choices() const {
  MaterialChoices made;
  Written& written = made.options;
  const auto word = [&](const QComboBox& box, const char* option) {
    const std::string chosen = box.currentData().toString().toStdString();
    if (!chosen.empty()) written.emplace_back(option, chosen);
    return chosen;
  };
  const auto text = [&](const QLineEdit& entry, const char* option) {
    const QString typed = entry.text().trimmed();
    if (!typed.isEmpty()) written.emplace_back(option, typed.toStdString());
    return typed;
  };
  made.columns.frequencyUnit = word(*frequencyUnit_, "--frequency-unit");
  made.columns.temperatureUnit = word(*temperatureUnit_, "--temperature-unit");
  made.columns.modulusUnit = word(*modulusUnit_, "--modulus-unit");
  const std::string modulus = word(*modulus_, "--modulus");
  if (!modulus.empty())
    made.columns.modulus = modulus == "shear" ? ModulusKind::Shear : ModulusKind::Tension;
  made.columns.frequencyColumn = text(*frequencyColumn_, "--frequency-column").toStdString();
  made.columns.temperatureColumn = text(*temperatureColumn_, "--temperature-column").toStdString();
  made.columns.storageColumn = text(*storageColumn_, "--storage-column").toStdString();
  made.columns.lossColumn = text(*lossColumn_, "--loss-column").toStdString();
  made.columns.lossTangentColumn = text(*lossTangentColumn_, "--tan-delta-column").toStdString();
  if (const QString typed = text(*poisson_, "--poisson-ratio"); !typed.isEmpty()) {
    bool isNumber = false;
    made.columns.poissonRatio = withoutGroups(typed).toDouble(&isNumber);
    if (!isNumber || !(made.columns.poissonRatio >= 0 && made.columns.poissonRatio <= 0.5))
      throw InputError("", "--poisson-ratio",
                       message("'{}' is not a number from 0 to 0.5", typed.toStdString()));
  }
  if (const QString typed = text(*temperature_, "--temperature"); !typed.isEmpty())
    made.columns.temperature = kelvins(typed, "--temperature");
  if (const QString typed = text(*instantaneous_, "--instantaneous-modulus"); !typed.isEmpty())
    made.instantaneousModulus = pascals(typed, "--instantaneous-modulus");
  if (const QString typed = text(*equilibrium_, "--equilibrium-modulus"); !typed.isEmpty())
    made.series.equilibriumModulus = pascals(typed, "--equilibrium-modulus");
  made.series.isLiquid = liquid_->isChecked();
  if (made.series.isLiquid) written.emplace_back("--liquid", "true");
  if (const QString typed = text(*reference_, "--reference-temperature"); !typed.isEmpty())
    made.referenceTemperature = kelvins(typed, "--reference-temperature");
  made.isVertical = vertical_->isChecked();
  if (made.isVertical) written.emplace_back("--vertical-shifts", "true");
  const std::string shift = word(*shift_, "--shift");
  if (!shift.empty())
    made.shift = shift == "wlf"         ? ShiftKind::Wlf
                 : shift == "arrhenius" ? ShiftKind::Arrhenius
                                        : ShiftKind::Table;
  made.series.terms = terms_->value();
  if (terms_->value() > 0) written.emplace_back("--terms", std::to_string(terms_->value()));
  made.name = text(*name_, "--name").toStdString();
  made.source = text(*source_, "--source").toStdString();
  return made;
}

/// Returns an error message of core with the names of the page's controls instead of options.
QString MaterialImport::withControlNames(const std::string& option, QString text) const {
  QString subject = option.empty() ? QString() : translatedText(option);
  for (const auto& [name, control] : controls_) {
    const QString label = control->accessibleName();
    if (option == name) subject = label;
    // Not the beginning of a longer option.
    text.replace(QRegularExpression(QLatin1String(name) + QStringLiteral("(?![a-z-])")),
                 inQuotes(label));
  }
  return (subject.isEmpty() ? QFileInfo(file()).fileName() : subject) + ": " + text;
}

void MaterialImport::begin() {
  MaterialChoices chosen;
  try {
    chosen = choices();
  } catch (const InputError& error) {
    work_.cancel();
    return refuse(error.key(), error.message());
  }
  work_.request(
      [file = file().toStdString(), bytes = bytes_, chosen](const BackgroundWork::Run& run) {
        Preview preview{bytes, {}, {}};
        try {
          if (!preview.bytes)
            preview.bytes =
                std::make_shared<const std::string>(readRegularFile(file, kLargestFile));
          MaterialChoices choices = chosen;
          choices.stop = run.stop();
          preview.material = std::make_shared<const Material>(makeMaterial(
              *preview.bytes, std::filesystem::path(file).filename().string(), choices));
        } catch (const InputError& error) {
          preview.fault = {error.key(), error.message()};
        }
        return preview;
      },
      [this](const Preview& preview) { take(preview); },
      [this](const QString& reason) { finish(reason); });
}

/// Shows what is wrong with an entry (its option), or with the file.
void MaterialImport::refuse(const std::string& option, const Message& reason) {
  material_.reset();
  finish(withControlNames(option, translatedText(reason)));
}

void MaterialImport::take(const Preview& preview) {
  // A file with a fault is read again: the user may mend it meanwhile.
  bytes_ = preview.fault ? nullptr : preview.bytes;
  if (preview.fault) return refuse(preview.fault->first, preview.fault->second);
  material_ = preview.material;
  const std::vector<NamedSheet> sheets = materialSheets(*material_);
  const QString before = sheets_->tabData(sheets_->currentIndex()).toString();
  {
    const QSignalBlocker quiet(sheets_);
    while (sheets_->count() > 0) sheets_->removeTab(0);
    for (const NamedSheet& sheet : sheets) {
      const QString title = sheet.name == "isotherms"      ? tr("Isotherms")
                            : sheet.name == "master_curve" ? tr("Master curve")
                            : sheet.name == "loss_tangent" ? tr("Loss tangent")
                                                           : tr("Shifts");
      const int index = sheets_->addTab(title);
      sheets_->setTabData(index, QString::fromStdString(sheet.name));
      const bool isFirst = before.isEmpty() && sheet.name == "master_curve";
      if (isFirst || before.toStdString() == sheet.name) sheets_->setCurrentIndex(index);
    }
  }
  showSheet();
  QStringList lines, warnings;
  for (const Message& line : materialSummary(*material_))
    lines += sentence(withLabels(translatedText(line)));
  // Warnings come first, where they are visible without scrolling.
  if (material_->isMeasured() && !material_->curve.isThermorheologicallySimple)
    warnings += lines.takeLast();
  showWarnings(*warnings_, warnings);
  summary_->setText(keptTogether(lines.join('\n')));
  if (material_->isMeasured())
    reference_->setPlaceholderText(translatedText(celsius(material_->referenceTemperature)));
  finish({});
}

void MaterialImport::showSheet() {
  const std::string name = sheets_->tabData(sheets_->currentIndex()).toString().toStdString();
  sheet_->show([material = material_, name]() -> DiagramSheet {
    if (material)
      for (NamedSheet& sheet : materialSheets(*material))
        if (sheet.name == name) return std::move(sheet.sheet);
    return {};
  });
}

/// Writes the material first; where that fails or is called off, the page stays.
void MaterialImport::accept() {
  if (!material_ || !isReady()) return;
  const QFileInfo read(file());
  const QString proposed = read.dir().filePath(read.completeBaseName() + ".material.json");
  QString written = chooser_(this, proposed);
  if (written.isEmpty()) return;
  try {
    const std::filesystem::path path = std::filesystem::absolute(written.toStdString());
    checkReplacesNone(path, std::array{std::filesystem::path(file().toStdString())});
    writeFileAtomically(path, materialJson(*material_));
    written = QString::fromStdString(path.string());
  } catch (const std::exception& error) {
    return showFailure(translatedError(error));
  }
  emit materialWritten(written);
  QDialog::accept();
}

}  // namespace asperity
