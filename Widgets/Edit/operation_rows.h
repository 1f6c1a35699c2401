// Operations on handles as rows that a hand changes one by one, and the text that they are.
#ifndef oversketch_widgets_edit_operation_rows_h
#define oversketch_widgets_edit_operation_rows_h

#include "Matrix/operations.h"

#include <string>
#include <vector>

namespace oversketch
{

std::string operationText(const std::vector<Operation>& rows);
std::string operationText(const Operation& row);
// The same for a person: "moved outward 0.1", "turned 54°".
std::string operationWords(const Operation& row);

// The row of a handle's axis by a further amount: the same axis again changes its row, another one makes one,
// which takes the place of the handle's pin. A length and an angle add up, a factor multiplies; within what
// is allowed: 179 degrees, factors from 0.05 to 20.
void operate(std::vector<Operation>& rows, Verb verb, double t, int axis, double amount);

// The places of handles, ascending, each once; a drag has none.
std::vector<double> handlePlaces(const std::vector<Operation>& rows);

} // namespace oversketch
#endif
