// Findings of a check for printing, in words: a sentence a fact, sizes in millimetres.
#ifndef oversketch_kernels_print_print_facts_h
#define oversketch_kernels_print_print_facts_h

#include "Mesh/message.h"
#include "Print/print_check.h"

#include <vector>

namespace oversketch
{

struct PrintFact
{
  Message words;
  bool isFault = false; // it keeps the mesh from being printed, and the words end with the remedy
};

// `wall` [length of the mesh]: none is to be thinner; 0: any will do. `unit`: millimetres of a length of 1.
// The last fact is the verdict.
std::vector<PrintFact> printFacts(const PrintCheck& check, double wall, double unit);

} // namespace oversketch
#endif
