# reference.awk - shows the public headers and the Markdown pages to Doxygen.
#
# The headers' comments are plain English in plain /* */; this filter gives them the marks that Doxygen wants:
#   /* text */ before a declaration, or behind it   documentation of it.  One comment over several
#                                                    declarations without a blank line between is that of all
#   a line "name, name2    text", indented          a parameter; in other comments an entry of a list
#   other indented lines                            code
#   Errors: Guarantee: Cost: Source: Returns Since  a section
#   algsurf_name, ALGSURF_NAME, E_NAME              a link, so that Doxygen warns of names that are none
# In Markdown, links to files that are no pages of the reference become their text; pictures go by their names.

function escaped(s) {
    gsub(/[\\@<>&#%*]/, "\\\\&", s)
    gsub(/[.][.] /, "..\\&nbsp;", s) # a sentence does not end there, nor in the next line
    gsub(/ ch[.] /, " ch.\\&nbsp;", s)
    return s
}

function linked(s,    out, word, before) {
    while (match(s, /(algsurf|ALGSURF|E)_[A-Za-z_]+[A-Za-z]|(NOT_CONVERGED|NOT_VERIFIED|CANCELLED|UNCERTAIN|OK)/)) {
        before = substr(s, RSTART - 1, RSTART > 1)
        word = substr(s, RSTART, RLENGTH)
        out = out substr(s, 1, RSTART - 1)
        s = substr(s, RSTART + RLENGTH)
        if (before ~ /[A-Za-z_`]/ || s ~ /^[A-Za-z_]/) out = out word
        else out = out "@ref " (word ~ /^(algsurf|ALGSURF)_/ ? "" : "ALGSURF_") word " \"" word "\""
    }
    return out s
}

# Sections inside a paragraph, each on a line of its own.
function sectioned(s,    out, head) {
    while (match(s, /(Errors|Guarantee|Cost|Source)(, [A-Za-z]+)*: |Returns |Since [0-9]/)) {
        head = substr(s, RSTART, RLENGTH)
        if (RSTART > 1 && substr(s, 1, RSTART - 1) !~ /[.] *$/) {
            out = out substr(s, 1, RSTART - 1 + RLENGTH)
            s = substr(s, RSTART + RLENGTH)
            continue
        }
        out = out substr(s, 1, RSTART - 1)
        s = substr(s, RSTART + RLENGTH)
        if (head ~ /^Since/) out = out "\n@since " substr(head, 7)
        else if (head ~ /^Returns/) out = out "\n@return "
        else {
            sub(/: $/, "", head)
            out = out "\n@par " head "\n"
        }
    }
    return out s
}

function flush_paragraph(    s) {
    if (paragraph != "") s = linked(sectioned(escaped(paragraph)))
    if (s != "") documentation = documentation s "\n\n"
    paragraph = ""
}

function flush_item(    s) {
    if (item != "") documentation = documentation (of_function ? "@param " : "- <b>") item_name \
        (of_function ? " " : "</b>: ") linked(escaped(item)) "\n\n"
    item = ""
}

function flush_code() {
    if (code != "") documentation = documentation "@code{.unparsed}\n" code "@endcode\n"
    code = ""
}

# The comment's text, its lines in text[1..lines], as documentation.
function convert(    i, s, indent, names) {
    documentation = paragraph = item = code = ""
    for (i = 1; i <= lines; i++) {
        s = text[i]
        match(s, /^ */)
        indent = RLENGTH
        if (item != "" && indent > item_indent) {
            sub(/^ +/, "", s)
            item = item " " s
            continue
        }
        flush_item()
        if (indent >= 2 && match(s, /^ +[A-Za-z_]+(,? [A-Za-z_]+)*  +/)) {
            item_indent = indent
            item_name = substr(s, 1, RLENGTH)
            item = substr(s, RLENGTH + 1)
            gsub(/^ +| +$/, "", item_name)
            if (of_function) gsub(/, /, ",", item_name)
            flush_paragraph()
            flush_code()
        } else if (indent >= 2) {
            flush_paragraph()
            code = code s "\n"
        } else {
            flush_code()
            if (s == "" || (s ~ /^[A-Z]/ && paragraph ~ /(Errors|Guarantee|Cost|Source).*[.]$/ &&
                            s !~ /^(Errors|Guarantee|Cost|Source|Returns|Since)/)) flush_paragraph()
            paragraph = paragraph (paragraph == "" || s == "" ? "" : " ") s
        }
    }
    flush_item()
    flush_code()
    flush_paragraph()
    return documentation
}

function add_line(s) {
    sub(/ +$/, "", s)
    text[++lines] = s
}

# A comment that starts in s, "/* ..." up to its end in this line or a later one; `prefix` is what its other
# lines start with.
function read_comment(s, prefix) {
    lines = 0
    sub(/^\/\* ?/, "", s)
    while (s !~ /\*\/ *$/) {
        add_line(s)
        if ((getline s) <= 0) return
        if (s !~ /^ *\*\/ *$/) sub(prefix, "", s)
    }
    sub(/ *\*\/ *$/, "", s)
    add_line(s)
}

function document(    s) {
    s = convert()
    sub(/\n+$/, "", s)
    return "/** " s (s ~ /\n/ ? "\n" : " ") "*/"
}

# "double a, *b[3];" as "double a; double *b[3];", each with the comment.
function split_declaration(comment, s,    n, i, name, type) {
    sub(/; *$/, "", s)
    n = split(s, name, /, */)
    type = name[1]
    sub(/[*A-Za-z_0-9]+(\[[^]]*\])* *$/, "", type)
    for (i = 1; i <= n; i++) print comment "\n" (i > 1 ? type : "") name[i] ";"
}

FILENAME ~ /\.md$/ {
    line = $0
    out = ""
    while (match(line, /!?\[[^]]*\]\([^)]*\)/)) {
        link = substr(line, RSTART, RLENGTH)
        out = out substr(line, 1, RSTART - 1)
        line = substr(line, RSTART + RLENGTH)
        if (link ~ /^!/) sub(/\(.*\//, "(", link)
        else if (link !~ /\]\((https?:|#|(\.\.\/\.\.\/)?(include\/algsurf\/)?README\.md|((\.\.\/\.\.\/)?examples\/guide\/)?[a-z-]+\.md)/) {
            sub(/\]\(.*$/, "", link)
            sub(/^\[/, "", link)
        } else sub(/\.md#[^)]*/, ".md", link) # headings of other pages have other names there
        out = out link
    }
    print out line
    next
}

/^\/\* ---- / { next } # a heading between declarations

/^\/\* / {
    read_comment($0, "^ \\* ?")
    pending = 1
    if (text[1] ~ /^algsurf\/.*\.h - /) {
        sub(/^algsurf\/.*\.h - /, "", text[1])
        text[1] = toupper(substr(text[1], 1, 1)) substr(text[1], 2)
        of_function = 0
        print "/** @file\n" substr(document(), 5)
        pending = 0
    }
    next
}

/^#define ALGSURF_API|^#define ALGSURF_STATUS_ENUM|^#undef ALGSURF_STATUS_ENUM/ { next }

# The list of outcomes as enumerators.
/^ *X\(ALGSURF_/ {
    split($0, part, /X\(|, |"/)
    meaning = substr($0, index($0, "\"") + 1)
    sub(/"\).*/, "", meaning)
    outcomes = outcomes "/** " escaped(meaning) " */ " part[2] " = " part[3] ",\n"
}
/ALGSURF_STATUS_LIST\(ALGSURF_STATUS_ENUM\)/ { printf "%s", outcomes; next }

# Code with a comment behind it.
/[;,{0-9a-z)] *\/\* / && !/^#/ {
    at = index($0, "/* ")
    declaration = substr($0, 1, at - 1)
    read_comment(substr($0, at), "^ +")
    of_function = 0
    comment = document()
    if (declaration ~ /;/) split_declaration(comment, declaration)
    else print comment "\n" declaration
    next
}

{
    starts = /^ALGSURF_API |^typedef |^#define /
    if (starts && (pending || follows)) {
        of_function = /^ALGSURF_API |\(\*/
        print document()
        pending = 0
    }
    follows = starts ? /^(ALGSURF_API|#define) / : follows && $0 != "" && !/^[#}]/
    print
}
