<?php
// For tools/moodle_server.py. As a script: imports questions into the Moodle of a folder and answers
// them there, in each language and in two behaviours; prints as JSON what came of each answer.
// As the router of PHP's web server: /shown is a page with one question that has been answered.

$isPage = PHP_SAPI === 'cli-server';
if ($isPage && strtok($_SERVER['REQUEST_URI'], '?') !== '/shown') {
    return false;
}
define('CLI_SCRIPT', !$isPage);
[, $folder, $quiz, $answers] = $isPage ? [0, $_SERVER['DOCUMENT_ROOT'], 0, 0] : $argv;
require("$folder/config.php");
require_once("$CFG->libdir/questionlib.php");
require_once("$CFG->dirroot/question/format/xml/format.php");
require_once("$CFG->dirroot/question/engine/lib.php");

\core\session\manager::set_user(get_admin());
$context = context_course::instance(SITEID);
$PAGE->set_context($context);
$PAGE->set_url('/');

function import($quiz, $context) {
    $format = new qformat_xml();
    $format->setCategory(question_make_default_categories([$context]));
    $format->setContexts([$context]);
    $format->setCourse(get_site());
    $format->setFilename($quiz);
    $format->setRealfilename('quiz.xml');
    $format->setMatchgrades('error');
    $format->setCatfromfile(true);
    $format->setContextfromfile(false);
    $format->setStoponerror(true);
    $format->set_display_progress(false);
    return $format->importpreprocess() && $format->importprocess() && $format->importpostprocess();
}

function load($name) {
    global $DB;
    $record = $DB->get_record('question', ['name' => $name, 'parent' => 0], 'id', MUST_EXIST);
    return question_bank::load_question($record->id);
}

// A question that has got texts: by its own button, or when the attempt is finished.
function answered($question, $behaviour, $given) {
    global $context;
    $usage = question_engine::make_questions_usage_by_activity('core_question_preview', $context);
    $usage->set_preferred_behaviour($behaviour);
    $slot = $usage->add_question($question, 1.0);
    $usage->start_question($slot);
    $fields = fn($n) => 'sub' . ($n + 1) . '_answer';
    $names = count($given) > 1 ? array_map($fields, array_keys($given)) : ['answer'];
    $button = $behaviour === 'deferredfeedback' ? [] : ['-submit' => 1];
    $usage->process_action($slot, array_combine($names, $given) + $button);
    if (!$button) {
        $usage->finish_question($slot);
    }
    return [$usage, $slot];
}

if ($isPage) {
    $PAGE->set_pagelayout('incourse');
    force_current_language($_GET['lang']);
    [$usage, $slot] = answered(load($_GET['name']), 'immediatefeedback', $_GET['given']);
    $html = $usage->render_question($slot, new question_display_options(), '1');
    echo $OUTPUT->header(), $html, $OUTPUT->footer();
    return;
}

$result = ['imported' => import($quiz, $context), 'found' => []];
$result['questions'] = $DB->count_records_select('question', "parent = 0 AND qtype <> 'random'");
$result['release'] = $CFG->release;
$plain = fn($html) => strip_tags(html_entity_decode($html, ENT_QUOTES | ENT_HTML5));
$words = new question_display_options();
$words->generalfeedback = question_display_options::HIDDEN;  // it has the words of all mistakes
foreach (json_decode(file_get_contents($answers)) as $asked) {
    foreach ($asked->languages as $language) {
        force_current_language($language);
        $sign = get_string('decsep', 'langconfig');
        $question = load($asked->name);  // it keeps the signs of the language
        foreach ($asked->tries as $try) {
            $given = str_replace('.', $sign, $try->given);
            foreach (['immediatefeedback', 'deferredfeedback'] as $behaviour) {
                [$usage, $slot] = answered($question, $behaviour, $given);
                $asks = $try->says && $behaviour === 'immediatefeedback';
                $html = $asks ? $plain($usage->render_question($slot, $words)) : '';
                $result['found'][] = [
                    'name' => $asked->name,
                    'language' => $language,
                    'behaviour' => $behaviour,
                    'what' => $try->what,
                    'given' => $given,
                    'mark' => round((float) $usage->get_question_fraction($slot), 4),
                    'told' => $asks ? strpos($html, $try->says) !== false : null,
                ];
            }
        }
    }
}
echo "\n", json_encode($result);
