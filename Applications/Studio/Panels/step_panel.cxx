#include "step_panel.h"

#include "line_form.h"
#include "system_strings.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <optional>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr int sliderSteps = 200;
constexpr const char* exactValue = "exactValue"; // a property of a slider, of a box

using Numbers = std::vector<double>;

// "0 1.5 0", in which a point is a point in every language.
QString numbersText(const Numbers& numbers)
{
  QStringList words;
  for (const double number : numbers)
  {
    words << QString::number(number, 'g', QLocale::FloatingPointShortest);
  }
  return words.join(' ');
}

// As many as wanted, or one for all of them; none where it is no such text.
std::optional<Numbers> numbersIn(const QString& text, std::size_t count, bool oneForAll)
{
  Numbers numbers;
  for (const QString& word : text.split(QRegularExpression("[\\s,;]+"), Qt::SkipEmptyParts))
  {
    bool isNumber = false;
    numbers.push_back(word.toDouble(&isNumber));
    if (!isNumber || !std::isfinite(numbers.back()))
    {
      return std::nullopt;
    }
  }
  if (oneForAll && numbers.size() == 1)
  {
    return Numbers(count, numbers.front());
  }
  return numbers.size() == count ? std::optional<Numbers>(numbers) : std::nullopt;
}

} // namespace

QComboBox* StepPanel::mirrorChoice(QWidget* parent)
{
  auto* choice = new QComboBox(parent);
  choice->addItems({ tr("Off"), tr("Left–right (x)"), tr("Up–down (y)"), tr("Front–back (z)") });
  return choice;
}

StepPanel::StepPanel(QWidget* parent)
  : QStackedWidget(parent)
{
  for (const SystemRow& row : systems())
  {
    this->addPage(row);
  }
  this->addPage(lineRow());
  if (!systems().empty())
  {
    this->turnTo(systems().front().name);
  }
}

void StepPanel::addPage(const SystemRow& row)
{
  Page page;
  page.system = row.name;
  // A small window scrolls a form that has many rows.
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  page.widget = scroll;
  auto* rows = new QWidget(scroll);
  auto* form = new QFormLayout(rows);
  form->setContentsMargins(0, 0, 0, 0);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  for (const Parameter& parameter : row.parameters)
  {
    const Field field = this->addField(parameter, rows, form);
    if (field.widget)
    {
      page.fields.push_back(field);
    }
  }
  if (row.mirroring != Mirroring::None)
  {
    page.mirror = mirrorChoice(rows);
    page.mirror->setFocusPolicy(Qt::StrongFocus);
    page.mirror->installEventFilter(this);
    page.mirror->setAccessibleName(tr("Mirror"));
    page.mirror->setToolTip(tr("One side of the model, or both sides of this plane. Where the two are the "
                               "same, there are no new triangles."));
    form->addRow(tr("Mirror"), page.mirror);
    connect(page.mirror, QOverload<int>::of(&QComboBox::activated), this, &StepPanel::read);
  }
  scroll->setWidget(rows);
  scroll->setMinimumWidth(rows->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
  this->addWidget(page.widget);
  this->Pages[row.name] = page;
}

// A choice is a combo box, yes or no a check box, a number a spin box, several are a line; others are the
// command's.
StepPanel::Field StepPanel::addField(const Parameter& parameter, QWidget* page, QFormLayout* form)
{
  Field field;
  field.parameter = &parameter;
  const QString title = rowText(parameter.title);
  if (!parameter.choices.empty())
  {
    auto* choice = new QComboBox(page);
    for (const Choice& one : parameter.choices)
    {
      choice->addItem(rowText(one.title));
    }
    connect(choice, QOverload<int>::of(&QComboBox::activated), this, &StepPanel::read);
    field.widget = choice;
    field.read = [](QWidget* widget) -> Value { return static_cast<QComboBox*>(widget)->currentIndex(); };
    field.write = [](QWidget* widget, const Value& value)
    { static_cast<QComboBox*>(widget)->setCurrentIndex(std::get<int>(value)); };
  }
  else if (std::holds_alternative<bool>(parameter.initial))
  {
    auto* box = new QCheckBox(title, page);
    connect(box, &QCheckBox::clicked, this, &StepPanel::read);
    field.widget = box;
    field.read = [](QWidget* widget) -> Value { return static_cast<QCheckBox*>(widget)->isChecked(); };
    field.write = [](QWidget* widget, const Value& value)
    { static_cast<QCheckBox*>(widget)->setChecked(std::get<bool>(value)); };
  }
  else if (std::holds_alternative<int>(parameter.initial))
  {
    auto* number = new QSpinBox(page);
    const bool isRanged = parameter.least < parameter.most;
    number->setRange(isRanged ? static_cast<int>(parameter.least) : -1000000,
      isRanged ? static_cast<int>(parameter.most) : 1000000);
    if (isRanged && parameter.least == 0.0 && std::get<int>(parameter.initial) == 0)
    {
      number->setSpecialValueText(tr("automatic"));
    }
    connect(number, &QSpinBox::editingFinished, this, &StepPanel::read);
    field.widget = number;
    field.read = [](QWidget* widget) -> Value { return static_cast<QSpinBox*>(widget)->value(); };
    field.write = [](QWidget* widget, const Value& value)
    { static_cast<QSpinBox*>(widget)->setValue(std::get<int>(value)); };
  }
  else if (std::holds_alternative<double>(parameter.initial) && parameter.least < parameter.most)
  {
    auto* slider = new QSlider(Qt::Horizontal, page);
    slider->setRange(0, sliderSteps);
    slider->setTracking(false); // a value is a run
    connect(slider, &QSlider::valueChanged, this, &StepPanel::read);
    field.widget = slider;
    const double least = parameter.least, step = (parameter.most - least) / sliderSteps;
    const auto placeOf = [least, step](double value)
    { return static_cast<int>(std::lround((value - least) / step)); };
    // The number that it was set to comes back as it was, though the slider has fewer places.
    field.read = [=](QWidget* widget) -> Value
    {
      const int place = static_cast<QSlider*>(widget)->value();
      const double set = widget->property(exactValue).toDouble();
      return place == placeOf(set) ? set : least + place * step;
    };
    field.write = [=](QWidget* widget, const Value& value)
    {
      const QSignalBlocker quiet(widget);
      widget->setProperty(exactValue, std::get<double>(value));
      static_cast<QSlider*>(widget)->setValue(placeOf(std::get<double>(value)));
    };
  }
  else if (std::holds_alternative<double>(parameter.initial))
  {
    auto* number = new QDoubleSpinBox(page);
    number->setRange(-1e6, 1e6);
    connect(number, &QDoubleSpinBox::editingFinished, this, &StepPanel::read);
    field.widget = number;
    // The number that it was set to comes back as it was, though the box has fewer digits.
    field.read = [](QWidget* widget) -> Value
    {
      auto* box = static_cast<QDoubleSpinBox*>(widget);
      const double set = widget->property(exactValue).toDouble();
      return std::abs(box->value() - set) <= 0.5 * std::pow(10.0, -box->decimals()) ? set : box->value();
    };
    field.write = [](QWidget* widget, const Value& value)
    {
      auto* box = static_cast<QDoubleSpinBox*>(widget);
      const double set = std::get<double>(value);
      // Three digits of small numbers, too.
      const double digits = set == 0.0 ? 0.0 : std::floor(std::log10(std::abs(set)));
      box->setDecimals(std::clamp(2 - static_cast<int>(digits), 4, 12));
      widget->setProperty(exactValue, set);
      box->setValue(set);
    };
  }
  else if (std::holds_alternative<Numbers>(parameter.initial))
  {
    auto* line = new QLineEdit(page);
    connect(line, &QLineEdit::editingFinished, this, &StepPanel::read);
    field.widget = line;
    // A text that is none gives way to the last numbers.
    field.read = [&parameter](QWidget* widget) -> Value
    {
      auto* box = static_cast<QLineEdit*>(widget);
      const std::size_t count = std::get<Numbers>(parameter.initial).size();
      const auto typed = numbersIn(box->text(), count, parameter.oneForAll);
      const Numbers numbers = typed ? *typed : *numbersIn(box->property(exactValue).toString(), count, false);
      box->setText(numbersText(numbers));
      return numbers;
    };
    field.write = [](QWidget* widget, const Value& value)
    {
      const QString text = numbersText(std::get<Numbers>(value));
      widget->setProperty(exactValue, text);
      static_cast<QLineEdit*>(widget)->setText(text);
    };
  }
  else if (!parameter.offers.empty())
  {
    auto* text = new QComboBox(page);
    text->setEditable(true);
    for (const Choice& one : parameter.offers)
    {
      text->addItem(rowText(one.title), QString::fromStdString(one.word));
    }
    connect(text, QOverload<int>::of(&QComboBox::activated), this, &StepPanel::read);
    connect(text->lineEdit(), &QLineEdit::editingFinished, this, &StepPanel::read);
    field.widget = text;
    field.read = [](QWidget* widget) -> Value
    {
      const auto* box = static_cast<QComboBox*>(widget);
      const int offered = box->findText(box->currentText());
      return (offered < 0 ? box->currentText() : box->itemData(offered).toString()).toStdString();
    };
    field.write = [](QWidget* widget, const Value& value)
    {
      auto* box = static_cast<QComboBox*>(widget);
      const QString word = QString::fromStdString(std::get<std::string>(value));
      const int offered = box->findData(word);
      box->setEditText(offered < 0 ? word : box->itemText(offered));
    };
  }
  else
  {
    return field;
  }
  field.widget->setFocusPolicy(Qt::StrongFocus);
  field.widget->installEventFilter(this);
  field.widget->setToolTip(rowSentence(parameter.help));
  field.widget->setAccessibleName(title);
  const bool saysItself = std::holds_alternative<bool>(parameter.initial);
  saysItself ? form->addRow(field.widget) : form->addRow(title, field.widget);
  return field;
}

void StepPanel::show(const Step* step)
{
  const auto known = step ? this->Pages.find(step->system) : this->Pages.end();
  QWidget* typedInto = QApplication::focusWidget();
  const bool isLeft = known == this->Pages.end() || this->Shown != &known->second;
  const bool hadKeys = isLeft && typedInto && this->isAncestorOf(typedInto);
  if (hadKeys)
  {
    typedInto->clearFocus(); // what was typed is of the step that was shown, and is read as long as it is
  }
  if (known != this->Pages.end())
  {
    this->Shown = &known->second;
    this->setCurrentWidget(this->Shown->widget);
  }
  if (!this->Shown)
  {
    return;
  }
  const Step* seen = step || !this->unselected ? step : this->unselected(this->Shown->system);
  for (const Field& field : this->Shown->fields)
  {
    field.widget->setEnabled(step != nullptr);
    field.write(field.widget, seen ? valueOf(*seen, *field.parameter) : field.parameter->initial);
    if (auto* number = seen ? nullptr : qobject_cast<QDoubleSpinBox*>(field.widget))
    {
      number->clear(); // the system's word for its own choice says nothing
    }
  }
  this->StepValues = step ? step->values : Values();
  this->StepMirror = seen && seen->mirror ? seen->mirror->axis + 1 : 0;
  if (this->Shown->mirror)
  {
    this->Shown->mirror->setEnabled(step != nullptr);
    this->Shown->mirror->setCurrentIndex(this->StepMirror);
  }
  if (hadKeys)
  {
    emit this->keysLeft();
  }
}

bool StepPanel::eventFilter(QObject* watched, QEvent* event)
{
  const auto* widget = qobject_cast<QWidget*>(watched);
  if (event->type() == QEvent::Wheel && widget && !widget->hasFocus())
  {
    event->ignore(); // the form scrolls
    return true;
  }
  return QStackedWidget::eventFilter(watched, event);
}

void StepPanel::turnTo(const std::string& system)
{
  const auto known = this->Pages.find(system);
  if (known != this->Pages.end())
  {
    this->Shown = &known->second;
    this->setCurrentWidget(this->Shown->widget);
    this->show(nullptr);
  }
}

void StepPanel::read()
{
  Values values = this->StepValues;
  for (const Field& field : this->Shown->fields)
  {
    values[field.parameter->property] = field.read(field.widget);
  }
  const int mirror = this->Shown->mirror ? this->Shown->mirror->currentIndex() : 0;
  if (values != this->StepValues || mirror != this->StepMirror)
  {
    emit this->edited(values, mirror);
  }
}

} // namespace oversketch_studio
