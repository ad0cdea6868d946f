<?php
// For tools/moodle_server.py: imports questions into the Moodle of a folder and answers them there.
// Arguments: the folder, the questions, what to answer. Prints, as JSON, what came of each answer.

define('CLI_SCRIPT', true);
[, $folder, $quiz, $answers] = $argv;
require("$folder/config.php");
require_once("$CFG->libdir/questionlib.php");
require_once("$CFG->dirroot/question/format/xml/format.php");
require_once("$CFG->dirroot/question/engine/lib.php");

\core\session\manager::set_user(get_admin());
$context = context_course::instance(SITEID);
$PAGE->set_context($context);
$PAGE->set_url('/');

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
$imported = $format->importpreprocess() && $format->importprocess() && $format->importpostprocess();

// A question that is started, in a behaviour.
function started($question, $behaviour) {
    global $context;
    $usage = question_engine::make_questions_usage_by_activity('core_question_preview', $context);
    $usage->set_preferred_behaviour($behaviour);
    $slot = $usage->add_question($question, 1.0);
    $usage->start_question($slot);
    return [$usage, $slot];
}

// What a browser sends for the texts that a student gives.
function response($usage, $slot, $given) {
    $question = $usage->get_question($slot);
    if ($question instanceof qtype_multianswer_question) {
        $names = array_map(fn($n) => 'sub' . ($n + 1) . '_answer', array_keys($given));
        return array_combine($names, $given);
    }
    if ($question instanceof qtype_multichoice_base) {
        $order = $question->get_order($usage->get_question_attempt($slot));
        $same = array_filter($order, fn($id) => $question->answers[$id]->answer === $given[0]);
        $wrong = array_filter($order, fn($id) => $question->answers[$id]->fraction < 0.5);
        return ['answer' => array_key_first($same ?: $wrong)];
    }
    return ['answer' => $given[0]];
}

$plain = fn($html) => html_entity_decode(strip_tags($html), ENT_QUOTES | ENT_HTML5);
$found = [];
foreach (json_decode(file_get_contents($answers)) as $asked) {
    $record = $DB->get_record('question', ['name' => $asked->name, 'parent' => 0], 'id', MUST_EXIST);
    $question = question_bank::load_question($record->id);
    foreach ($asked->tries as $try) {
        [$usage, $slot] = started($question, 'immediatefeedback');
        $usage->process_action($slot, response($usage, $slot, $try->given) + ['-submit' => 1]);
        $html = $usage->render_question($slot, new question_display_options());
        $found[] = [
            'exercise' => $asked->exercise,
            'what' => $try->what,
            'mark' => (float) $usage->get_question_fraction($slot),
            'told' => strpos($plain($html), $try->says) !== false,
        ];
    }
    $tries = 0;
    [$usage, $slot] = started($question, 'interactive');
    $wrong = array_fill(0, count($asked->tries[0]->given), '12345');
    do {
        $usage->process_action($slot, response($usage, $slot, $wrong) + ['-submit' => 1]);
        $tries++;
        $over = $usage->get_question_state($slot)->is_finished();
        if (!$over) {
            $usage->process_action($slot, ['-tryagain' => 1]);
        }
    } while (!$over && $tries < 9);
    $found[] = ['exercise' => $asked->exercise, 'what' => 'tries', 'mark' => $tries, 'told' => true];
}
$questions = $DB->count_records_select('question', "parent = 0 AND qtype <> 'random'");
echo "\n", json_encode(['imported' => $imported, 'questions' => $questions, 'found' => $found]);
