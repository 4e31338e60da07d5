// Checks the rules of the house over a tree and prints each place where one is broken, as file:line: rule:
// what. Exit code 0 when there is none, 1 when there are some, 2 when there is no tree.

#include <iostream>

#include "tests/rules/rules.h"

int main(int argc, char** argv) {
    using namespace kickstand::rules;
    if (argc != 2) {
        std::cerr << "usage: check_rules ROOT\n";
        return 2;
    }
    const Tree tree = loadTree(argv[1]);
    if (tree.files.empty()) {
        std::cerr << "check_rules: there is nothing to check in " << argv[1] << '\n';
        return 2;
    }
    std::size_t count = 0;
    for (const auto& check : {checkIncludes, checkTexts}) {
        for (const Violation& violation : check(tree)) {
            std::cout << violation.path << ':' << violation.line << ": " << violation.rule << ": "
                      << violation.message << '\n';
            ++count;
        }
    }
    std::cout << tree.files.size() << " files, " << count << " violations\n";
    return count == 0 ? 0 : 1;
}
