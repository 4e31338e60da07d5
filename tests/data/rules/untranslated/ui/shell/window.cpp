void Window::build() {
    label_->setText(tr("Battery"));
    label_->setText(QStringLiteral("Battery"));
    unit_->setText(QStringLiteral("V"));
    button_->setObjectName(QStringLiteral("stop"));
    button_->setToolTip("Brakes every robot.");
    auto* other = new QPushButton(QStringLiteral("Start"), this);
}
