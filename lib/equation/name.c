/* name.c - see read.h.
 *
 * Constants may be prefixes of each other, so at each letter of a name the longest one counts that is there.
 * All of them are found in one pass from the name's end to its beginning, with a tree of the constants'
 * names from their ends (Aho and Corasick, Efficient string matching, Comm. ACM 18, 1975): each node knows
 * where to go on when the name does, the node of its longest proper beginning that is in the tree, too, and
 * the longest constant that ends there.
 */
#include "../base/arithmetic.h"
#include "read.h"

#include <stdlib.h>

/* Node 0 is the root; 0 in a link is none, or the root. */
typedef struct algsurf_i_name_node {
    int code; /* of the letter that leads here */
    size_t child, sibling, fallback, queue;
    const algsurf_constant *constant; /* the longest one that ends here */
} node;

static size_t child_of(const node *tree, size_t at, int code) {
    size_t child = tree[at].child;
    while (child && tree[child].code != code) child = tree[child].sibling;
    return child;
}

/* The node after one more letter: of the longest end of what was read that is in the tree. */
static size_t step(const node *tree, size_t at, int code) {
    size_t next = child_of(tree, at, code);
    while (!next && at) at = tree[at].fallback, next = child_of(tree, at, code);
    return next;
}

/* Decodes the name at the start of text; constants are not known yet. */
static algsurf_status read_letters(algsurf_i_names *names, const char *text) {
    algsurf_i_letter letter = algsurf_i_letter_at(text);
    size_t at = 0, needed = algsurf_i_name_length(text) + 1;
    names->count = 0;
    if (needed > names->capacity) {
        algsurf_i_name_letter *room = realloc(names->letter, needed * sizeof *room);
        if (!room) return ALGSURF_E_NO_MEMORY;
        names->letter = room;
        names->capacity = needed;
    }
    for (; letter.width > 0; letter = algsurf_i_name_part_at(text + at)) {
        names->letter[names->count++] = (algsurf_i_name_letter){at, letter.code, NULL};
        at += letter.width;
    }
    names->letter[names->count] = (algsurf_i_name_letter){at, 0, NULL};
    return ALGSURF_OK;
}

/* A name is read from its end. */
algsurf_status algsurf_i_names_add(algsurf_i_names *names, const algsurf_constant *constant) {
    node *tree = names->node;
    size_t at = 0;
    algsurf_status status = read_letters(names, constant->name);
    if (status != ALGSURF_OK) return status;
    for (size_t i = names->count; i-- > 0;) {
        int code = names->letter[i].code;
        size_t next = child_of(tree, at, code);
        if (!next) {
            next = names->nodes++;
            tree[next] = (node){code, 0, tree[at].child, 0, 0, NULL};
            tree[at].child = next;
        }
        at = next;
    }
    if (tree[at].constant) return ALGSURF_E_ARGUMENT;
    tree[at].constant = constant;
    return ALGSURF_OK;
}

/* What a node falls back to is nearer to the root: the nodes are gone through by their depth. */
void algsurf_i_names_link(algsurf_i_names *names) {
    node *tree = names->node;
    size_t last = 0, at = 0;
    do {
        for (size_t child = tree[at].child; child; child = tree[child].sibling) {
            size_t fallback = at ? step(tree, tree[at].fallback, tree[child].code) : 0;
            tree[child].fallback = fallback;
            if (!tree[child].constant) tree[child].constant = tree[fallback].constant;
            tree[last].queue = child;
            last = child;
        }
        at = tree[at].queue;
    } while (at);
}

algsurf_status algsurf_i_names_make(algsurf_i_names *names, size_t bytes) {
    names->nodes = 1;
    names->node = calloc(bytes + 1, sizeof *names->node);
    return names->node ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

void algsurf_i_names_free(algsurf_i_names *names) {
    free(names->node);
    free(names->letter);
}

algsurf_status algsurf_i_names_read(algsurf_i_names *names, const char *text) {
    algsurf_status status = read_letters(names, text);
    for (size_t at = 0, i = names->count; status == ALGSURF_OK && i-- > 0;) {
        at = step(names->node, at, names->letter[i].code);
        names->letter[i].constant = names->node[at].constant;
    }
    return status;
}

static size_t parts_of(const algsurf_constant *constant) {
    return algsurf_i_name_parts(constant->name, algsurf_i_name_length(constant->name));
}

static int is_pi(const algsurf_i_name_letter *letter) {
    return (letter[0].code == 'p' || letter[0].code == 'P') &&
           (letter[1].code == 'i' || letter[1].code == 'I');
}

size_t algsurf_i_names_factor(const algsurf_i_names *names, size_t i, const algsurf_constant **constant) {
    const algsurf_i_name_letter *letter = names->letter + i;
    *constant = NULL;
    if (algsurf_i_variable(letter->code) && (letter->code >= 'x' || !letter->constant)) return 1;
    *constant = letter->constant;
    size_t parts = *constant ? parts_of(*constant) : 0;
    if (parts >= 2 || !is_pi(letter)) return parts; /* behind the last letter there is one more, of code 0 */
    *constant = NULL;
    return 2;
}

const algsurf_constant *algsurf_i_names_whole(const algsurf_i_names *names) {
    const algsurf_constant *constant = names->count ? names->letter[0].constant : NULL;
    if (!constant) return NULL;
    return parts_of(constant) == names->count ? constant : NULL;
}
