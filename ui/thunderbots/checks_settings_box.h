#pragma once

#include <QWidget>
#include <vector>

#include "core/thunderbots/bench_check.h"

class QCheckBox;
class QSettings;

namespace kickstand::ui {

class SignedSpinBox;

/// What a check is to check, and its limits: remembered from run to run, saved as a file and read again.
class ChecksSettingsBox final : public QWidget {
    Q_OBJECT
  public:
    explicit ChecksSettingsBox(QSettings& settings, QWidget* parent = nullptr);

    /// The plan as it is set.
    thunderbots::CheckPlan plan(thunderbots::RobotMask robots) const;
    void setLimits(const thunderbots::CheckLimits& limits);

  signals:
    /// A setting has changed.
    void edited();
    /// A file was no limits, and why.
    void refused(const QString& why);

  private:
    struct Part {
        QCheckBox* box;
        bool thunderbots::CheckPlan::*member;
    };

    QWidget* makeParts();
    QWidget* makeLimits();
    QWidget* makeFiles();
    void addPart(QWidget* parent, const char* name, const QString& text,
                 bool thunderbots::CheckPlan::*member);
    SignedSpinBox* makeField(const thunderbots::CheckLimitInfo& info, QWidget* parent);
    void askToLoad();
    void load(const QString& path);

    QSettings& settings_;
    std::vector<Part> parts_;
    std::vector<SignedSpinBox*> fields_;  ///< In the order of checkLimitInfos().
};

}  // namespace kickstand::ui
