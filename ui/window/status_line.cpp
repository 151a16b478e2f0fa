#include "ui/window/status_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <cmath>

#include "core/scene/element_law.h"
#include "ui/charts/decade_range.h"

namespace asperity {

namespace {

constexpr int kSaidFor = 5000;  // ms

double orMissing(double value) {
  return std::isfinite(value) ? value : kNotApplicable;
}

}  // namespace

double dimensionlessForce(const Frame& frame) {
  return orMissing(frame.normalForce / (lawOf(frame.scene->elastomer).equilibriumModulus *
                                        frame.rmsHeight * frame.length));
}

double dimensionlessVelocity(const Frame& frame) {
  const ElementLaw law = lawOf(frame.scene->elastomer);
  if (law.kind() != ElementKind::Kelvin) return kNotApplicable;
  return orMissing(law.relaxationTime * frame.scene->sliding.velocity * frame.rmsSlope /
                   (std::sqrt(2.0) * frame.rmsHeight));
}

StatusLine::StatusLine(QWidget* parent) : QWidget(parent) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(12, 3, 12, 3);
  line->setSpacing(26);
  mu_ = addFact(*line, "factMu", tr("Coefficient of friction of this line in steady sliding"));
  force_ =
      addFact(*line, "factForce",
              tr("Eq. (14) of the paper: normal force / (shear modulus × rms height × length)"));
  velocity_ = addFact(*line, "factVelocity",
                      tr("Eq. (13) of the paper: relaxation time × velocity × rms slope / "
                         "(√2 × rms height)"));
  said_ = addFact(*line, "said", {});
  said_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  said_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  line->setStretchFactor(said_, 1);
  silence_ = new QTimer(this);
  silence_->setSingleShot(true);
  connect(silence_, &QTimer::timeout, said_, &QLabel::clear);
  rate_ = addFact(*line, "factRate", tr("Pictures of the contact shown in the last second"));
  backend_ = addFact(*line, "factBackend", tr("What draws the contact"));
}

QLabel* StatusLine::addFact(QHBoxLayout& line, const char* name, const QString& tip) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setToolTip(tip);
  line.addWidget(label);
  return label;
}

void StatusLine::showFrame(const Frame& frame) {
  mu_->setText(tr("friction coefficient μ = %1").arg(readingLabel(frame.muSteady)));
  force_->setText(tr("dimensionless force F̄ = %1").arg(readingLabel(dimensionlessForce(frame))));
  velocity_->setText(
      tr("dimensionless velocity v̄ = %1").arg(readingLabel(dimensionlessVelocity(frame))));
}

void StatusLine::say(const QString& text) {
  said_->setText(text);
  silence_->start(kSaidFor);
}

void StatusLine::showDrawing(int framesPerSecond, const QString& backend) {
  rate_->setText(tr("%1 frames/s").arg(framesPerSecond));
  backend_->setText(backend);
}

}  // namespace asperity
