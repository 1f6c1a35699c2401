#include "option_presets.h"

#include "tool.h"

#include <QInputDialog>
#include <QLineEdit>
#include <QSettings>
#include <QVariant>

#include <string>
#include <type_traits>
#include <variant>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// No option of a tool is a list.
QVariant kept(const Value& value)
{
  return std::visit(
    [](const auto& one) -> QVariant
    {
      using T = std::decay_t<decltype(one)>;
      if constexpr (std::is_same_v<T, std::string>)
      {
        return QString::fromStdString(one);
      }
      else if constexpr (std::is_arithmetic_v<T>)
      {
        return one;
      }
      else
      {
        return {};
      }
    },
    value);
}

// In the type that the tool has; settings are texts.
Value readAs(const Value& like, const QVariant& value)
{
  return std::visit(
    [&](const auto& one) -> Value
    {
      using T = std::decay_t<decltype(one)>;
      if constexpr (std::is_same_v<T, std::string>)
      {
        return value.toString().toStdString();
      }
      else if constexpr (std::is_arithmetic_v<T>)
      {
        return value.value<T>();
      }
      else
      {
        return one;
      }
    },
    like);
}

// Where those of a tool are.
QString groupOf(const Tool& tool)
{
  return "presets/" + tool.objectName();
}

} // namespace

OptionPresets::OptionPresets(QWidget* parent)
  : QMenu(tr("P&resets"), parent)
{
  connect(this, &QMenu::aboutToShow, this, &OptionPresets::fill);
}

void OptionPresets::setTool(Tool* tool)
{
  this->Of = tool;
  this->setEnabled(!tool->options().empty());
}

QStringList OptionPresets::names() const
{
  QStringList names;
  for (const QVariant& one : QSettings().value(groupOf(*this->Of)).toMap())
  {
    names << one.toMap().value("name").toString();
  }
  names.sort(Qt::CaseInsensitive);
  return names;
}

void OptionPresets::keep(const QString& name) const
{
  QVariantMap values;
  for (const auto& [option, value] : this->Of->options())
  {
    values[QString::fromStdString(option)] = kept(value);
  }
  QSettings settings;
  QVariantMap all = settings.value(groupOf(*this->Of)).toMap();
  all[name] = QVariantMap{ { "name", name }, { "values", values } };
  settings.setValue(groupOf(*this->Of), all);
}

void OptionPresets::choose(const QString& name) const
{
  const QVariantMap values =
    QSettings().value(groupOf(*this->Of)).toMap().value(name).toMap().value("values").toMap();
  Values options = this->Of->options();
  for (auto& [option, value] : options)
  {
    const QVariant given = values.value(QString::fromStdString(option));
    value = given.isValid() ? readAs(value, given) : value;
  }
  this->Of->setOptions(options);
}

void OptionPresets::remove(const QString& name) const
{
  QSettings settings;
  QVariantMap all = settings.value(groupOf(*this->Of)).toMap();
  all.remove(name);
  settings.setValue(groupOf(*this->Of), all);
}

void OptionPresets::fill()
{
  this->clear();
  for (QMenu* old : this->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly))
  {
    old->deleteLater();
  }
  const QStringList there = this->names();
  for (const QString& name : there)
  {
    this->addAction(QString(name).replace('&', "&&"), this, [this, name] { this->choose(name); });
  }
  if (!there.isEmpty())
  {
    this->addSeparator();
  }
  this->addAction(tr("&Keep these options…"), this, &OptionPresets::keepAsked);
  if (!there.isEmpty())
  {
    QMenu* gone = this->addMenu(tr("&Remove"));
    for (const QString& name : there)
    {
      gone->addAction(QString(name).replace('&', "&&"), this, [this, name] { this->remove(name); });
    }
  }
}

void OptionPresets::keepAsked()
{
  bool wanted = false;
  const QString name = QInputDialog::getText(this->parentWidget(),
    tr("Keep these options"),
    tr("Name, such as Thin vein:"),
    QLineEdit::Normal,
    {},
    &wanted)
                         .trimmed();
  if (wanted && !name.isEmpty())
  {
    this->keep(name);
  }
}

} // namespace oversketch_studio
