/* SPDX-License-Identifier: MIT */
/* Texts in several languages, and the answers that a class chooses from. */
#include "assert_close.h"
#include "fake_catalog.h"
#include <string.h>

#define LESSON                                                                                                         \
    "lesson:\n  en: {title: Rolling, question: 'Which?', choices: 'a | b', right: 2}\n"                                \
    "  de: {title: Rollen, question: 'Welche?', choices: 'c | d', right: 2}\n"
#define LABELS "label: {en: rests, de: ruht}\n---\nlabel: {en: rolls, de: rollt}\n---\nlabel: slips\n"

static void the_language_is_chosen(void **state) {
    (void)state;
    char text[2048];
    snprintf(text, sizeof text, "%s%s%s", bodies_case, LESSON, LABELS);
    for (int de = 0; de < 2; de++) {
        const char *set = de ? "language=de" : "language=en";
        tr_scene s;
        tr_status st;
        if (!fake_read(&s, text, &set, 1, &st)) fail_msg("%s", st.text);
        assert_int_equal(s.language, de);
        assert_string_equal(s.lesson.title, de ? "Rollen" : "Rolling");
        assert_string_equal(s.lesson.question, de ? "Welche?" : "Which?");
        assert_int_equal(s.lesson.right, 2);
        assert_string_equal(s.label, de ? "ruht" : "rests");
        assert_string_equal(s.more[0].label, de ? "rollt" : "rolls");
        assert_string_equal(s.more[1].label, "slips");
        assert_string_equal(s.more[0].lesson.title, s.lesson.title);
        tr_scene_free(&s);
    }
}

static void without_the_language_the_first_is_taken(void **state) {
    (void)state;
    char text[2048];
    snprintf(text, sizeof text, "%slesson: {de: {title: Rollen}}\nlabel: {en: rests}\n", bodies_case);
    const char *sets[] = {"language=en", "language=de"};
    for (int i = 0; i < 2; i++) {
        tr_scene s;
        tr_status st;
        if (!fake_read(&s, text, &sets[i], 1, &st)) fail_msg("%s", st.text);
        assert_string_equal(s.lesson.title, "Rollen");
        assert_string_equal(s.label, "rests");
        tr_scene_free(&s);
    }
}

static void what_is_wrong_is_said(void **state) {
    (void)state;
    static const struct {
        const char *yaml, *says;
    } bad[] = {
        {"lesson: {en: {title: a, question: b}, de: {title: c}}\n",
         "`lesson.de` has no `question`, which `lesson.en` has"},
        {"lesson: {en: {title: a}, title: c}\n", "`lesson` has texts in languages, and `title` is none"},
        {"lesson: {title: a, de: {title: c}}\n", "unknown key `lesson.de`"},
        {"lesson: {en: {titel: a}}\n", "unknown key `lesson.titel` (did you mean `title`?)"},
        {"lesson: {en: a}\n", "`lesson` must be a mapping"},
        {"language: fr\n", "`fr` is not a choice for `language`; allowed is en | de"},
        {"lesson: {question: a, choices: b, right: 1}\n", "`choices` has 1 answers; allowed are 2 to 4"},
        {"lesson: {choices: a | b | c | d | e, right: 1}\n", "`choices` has 5 answers; allowed are 2 to 4"},
        {"lesson: {choices: a | b, right: 3}\n", "`right` is 3, and there are 2 choices"},
        {"lesson: {choices: a | b}\n", "`right` is 0, and there are 2 choices"},
        {"lesson: {right: 1}\n", "`right` is 1, and there are 0 choices"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char text[2048];
        snprintf(text, sizeof text, "%s%s", bodies_case, bad[i].yaml);
        tr_scene s;
        tr_status st;
        if (fake_read(&s, text, NULL, 0, &st)) fail_msg("read: %s", bad[i].yaml);
        if (!strstr(st.text, bad[i].says)) fail_msg("%s\nsays %s\nnot %s", bad[i].yaml, st.text, bad[i].says);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_language_is_chosen),
        cmocka_unit_test(without_the_language_the_first_is_taken),
        cmocka_unit_test(what_is_wrong_is_said),
    };
    return cmocka_run_group_tests_name("language", tests, NULL, NULL);
}
