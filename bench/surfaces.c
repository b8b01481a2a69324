/* surfaces.c - see surfaces.h. */
#include "surfaces.h"

void surfaces_add(surface_list *list, const catalogue_entry *entry) {
    if (list->count == list->most) cli_fail(CLI_BAD_INPUT, "more than %d surfaces", list->most);
    list->entry[list->count++] = entry;
}

void surfaces_add_named(surface_list *list, const char *const *names, size_t count) {
    for (size_t i = 0; i < count; i++) surfaces_add(list, catalogue_find(names[i]));
}

void surfaces_set(const cli_option *option, const char *value, void *field) {
    const catalogue_entry *entry = catalogue_find(value);
    if (!entry) cli_expected(option, value);
    surfaces_add(field, entry);
}
