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
#include <optional>
#include <tuple>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/regular_file.h"
#include "core/chart/material_sheets.h"
#include "core/material/material_options.h"
#include "core/material/material_summary.h"
#include "core/material/text_quantities.h"
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

/// Returns a number that may have a unit, as the command reads it.
QString asQuantity(const QString& text, const char*) {
  return withoutGroups(text);
}

/// The page shows degrees Celsius, and the command takes a number alone in kelvins.
QString asTemperature(const QString& text, const char* option) {
  const QString typed = withoutGroups(text);
  const std::string given = text.toStdString();
  bool hasNoUnit = false;
  (void)typed.toDouble(&hasNoUnit);
  if (hasNoUnit)
    throw InputError("", option,
                     message("'{}' has no unit; write \u00B0C, K or \u00B0F after it", given));
  if (!parseTemperature(typed.toStdString()))
    throw InputError(
        "", option,
        message("'{}' is not a temperature such as 20 \u00B0C, 293.15 K or 68 \u00B0F", given));
  return typed;
}

QString askForMaterial(QWidget* parent, const QString& proposed) {
  return askSaveFile(parent, MaterialImport::tr("Save material"), proposed,
                     MaterialImport::tr("Materials (*.json)"));
}

}  // namespace

MaterialImport::MaterialImport(const QString& file, QWidget* parent)
    : ImportPage(file, tr("&Save and use…"), parent),
      chooser_(askForMaterial),
      sheet_(named<DiagramView>("dmaSheet")),
      sheets_(named<QTabBar>("dmaSheets")),
      warnings_(warningTextLabel("dmaWarnings")),
      summary_(textLabel("dmaSummary")) {
  setObjectName("materialImport");
  setWindowTitle(tr("Open material"));
  buildViews();
  buildChoices();
  restart();
}

void MaterialImport::buildViews() {
  sheets_->setDrawBase(false);
  sheets_->setExpanding(false);
  sheets_->setUsesScrollButtons(true);
  connect(sheets_, &QTabBar::currentChanged, this, &MaterialImport::showSheet);
  sheet_->setAccessibleName(tr("the measured moduli and their fit"));
  warnings_->hide();
  views().addWidget(sheets_);
  views().addWidget(sheet_, 1);
  views().addWidget(scrolledTexts({warnings_, summary_}, 8, tr("summary of the material")));
}

QLineEdit* MaterialImport::addEntry(QFormLayout& form, const char* option, const char* name,
                                    const QString& label, const QString& tip, Reader read) {
  auto* entry = addField<QLineEdit>(form, name, label, tip);
  connect(entry, &QLineEdit::editingFinished, this, [this, entry] {
    if (!entry->isModified()) return;
    entry->setModified(false);
    restart();
  });
  controls_.push_back({option, label, [entry, option, read] {
                         const QString text = entry->text().trimmed();
                         return read && !text.isEmpty() ? read(text, option) : text;
                       }});
  return entry;
}

void MaterialImport::addChoice(QFormLayout& form, const char* option, const char* name,
                               const QString& label, const QString& tip, const QString& automatic,
                               const QStringList& words) {
  auto* box = addField<ChoiceBox>(form, name, label, tip);
  box->addItem(automatic, QString());
  for (const QString& word : words) box->addItem(wordText(word.toStdString()), word);
  connect(box, &QComboBox::activated, this, [this] { restart(); });
  controls_.push_back({option, label, [box] { return chosenWord(*box); }});
}

void MaterialImport::addCheck(QFormLayout& form, const char* option, const char* name,
                              const QString& label, const QString& tip) {
  auto* box = named<QCheckBox>(name, label);
  box->setAccessibleName(label);
  box->setToolTip(tip);
  connect(box, &QCheckBox::toggled, this, [this] { restart(); });
  form.addRow(QString(), box);
  controls_.push_back({option, label, [box] { return QString(box->isChecked() ? "true" : ""); }});
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
  addEntry(*form, "--name", "dmaName", tr("name"), tr("Name of the material"))
      ->setPlaceholderText(QFileInfo(file()).completeBaseName());
  addEntry(*form, "--source", "dmaSource", tr("source"),
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
  addChoice(form, "--frequency-unit", "dmaFrequencyUnit", tr("unit of frequency"),
            tr("Unit of the frequencies"), fromFile, {"Hz", "rad/s"});
  addChoice(form, "--temperature-unit", "dmaTemperatureUnit", tr("unit of temperature"),
            tr("Unit of the temperatures"), fromFile, {"C", "K", "F"});
  addChoice(form, "--modulus-unit", "dmaModulusUnit", tr("unit of modulus"),
            tr("Unit of the moduli"), fromFile, {"Pa", "kPa", "MPa", "GPa"});
  addChoice(form, "--modulus", "dmaModulus", tr("kind of modulus"),
            tr("Whether the moduli are of shear (G) or of tension (E)"), fromFile,
            {"shear", "tension"});
  addEntry(form, "--poisson-ratio", "dmaPoisson", tr("Poisson's ratio"),
           tr("Turns moduli of tension into those of shear: G = E / (2 (1 + ν))"), asQuantity)
      ->setPlaceholderText(inLanguage(QStringLiteral("0.5")));
  addEntry(form, "--temperature", "dmaTemperature", tr("test temperature"),
           tr("Temperature of a file that does not state one, such as 20 °C"), asTemperature)
      ->setPlaceholderText(fromFile);
  addEntry(form, "--instantaneous-modulus", "dmaInstantaneous", tr("instantaneous modulus G₀"),
           tr("Shear modulus in Pa or MPa of a series that gives parts of it"), asQuantity)
      ->setPlaceholderText(fromFile);
}

void MaterialImport::addColumns(QFormLayout& form) {
  addHeading(form, tr("Columns of the table"));
  const QString tip = tr("Name of the column, or its number from 1 on");
  for (const auto& [option, name, label] :
       std::initializer_list<std::tuple<const char*, const char*, QString>>{
           {"--frequency-column", "dmaFrequencyColumn", tr("frequency column")},
           {"--temperature-column", "dmaTemperatureColumn", tr("temperature column")},
           {"--storage-column", "dmaStorageColumn", tr("storage modulus column")},
           {"--loss-column", "dmaLossColumn", tr("loss modulus column")},
           {"--tan-delta-column", "dmaLossTangentColumn", tr("loss tangent column")}})
    addEntry(form, option, name, label, tip)->setPlaceholderText(tr("found by its name"));
}

void MaterialImport::addMasterCurve(QFormLayout& form) {
  addHeading(form, tr("Master curve"));
  reference_ =
      addEntry(form, "--reference-temperature", "dmaReference", tr("reference temperature"),
               tr("Temperature to which all isotherms are shifted, such as 20 °C"), asTemperature);
  reference_->setPlaceholderText(tr("near 25 °C"));
  addCheck(form, "--vertical-shifts", "dmaVertical", tr("vertical shifts, too"));
  addChoice(form, "--shift", "dmaShift", tr("temperature shift"),
            tr("How the material keeps the shifts with temperature: by the formula of "
               "Williams, Landel and Ferry, by that of Arrhenius, or as their table"),
            tr("automatic"), {"wlf", "arrhenius", "table"});
}

void MaterialImport::addSeries(QFormLayout& form) {
  addHeading(form, tr("Prony series"));
  const QString label = tr("number of terms");
  auto* terms = addField<SpinBox>(form, "dmaTerms", label,
                                  tr("Relaxation times, evenly spaced in their logarithm"));
  terms->setRange(0, kMaxTerms);
  terms->setSpecialValueText(tr("as few as needed"));
  connect(terms, &QSpinBox::valueChanged, this, [this] { restart(); });
  controls_.push_back({"--terms", label, [terms] {
                         return terms->value() > 0 ? QString::number(terms->value()) : QString();
                       }});
  addEntry(form, "--equilibrium-modulus", "dmaEquilibrium", tr("equilibrium modulus G∞"),
           tr("Shear modulus in Pa or MPa where it is known from elsewhere"), asQuantity)
      ->setPlaceholderText(tr("from the fit"));
  addCheck(form, "--liquid", "dmaLiquid", tr("allow G∞ = 0 (a liquid)"),
           tr("Whether the material may flow, without an equilibrium modulus"));
}

/// Returns the present choices. Throws InputError (option) where an entry is invalid.
MaterialChoices MaterialImport::choices() const {
  WrittenOptions written;
  for (const Control& control : controls_)
    if (const QString value = control.value(); !value.isEmpty())
      written.emplace_back(control.option, value.toStdString());
  return materialChoices(written);
}

/// Returns an error message of core with the names of the page's controls instead of options.
QString MaterialImport::withControlNames(const std::string& option, QString text) const {
  QString subject = option.empty() ? QString() : translatedText(option);
  for (const Control& control : controls_) {
    if (option == control.option) subject = control.label;
    // Not the beginning of a longer option.
    text.replace(QRegularExpression(QLatin1String(control.option) + QStringLiteral("(?![a-z-])")),
                 inQuotes(control.label));
  }
  return (subject.isEmpty() ? QFileInfo(file()).fileName() : subject) + ": " + text;
}

void MaterialImport::begin() {
  MaterialChoices chosen;
  try {
    chosen = choices();
  } catch (const InputError& error) {
    work().cancel();
    return refuse(error.key(), error.message());
  }
  work().request(
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
